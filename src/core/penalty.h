#pragma once

#include "ricochet/problem.h"

namespace ricochet {

/// The problem without constraints, for solvers that take none: the objective plus `weight` > 0
/// times the sum of the violations (of an equality its absolute value). This is the exact l1
/// penalty (Nocedal and Wright, Numerical Optimization, section 17.2). The name stays the same, and
/// so do the true objective and true violation on which it is scored. Its derivatives, if any, are
/// one-sided at the kinks. It has no residuals: it is no sum of squares.
Problem penalised(const Problem& problem, double weight);

}  // namespace ricochet
