#pragma once

#include "src/core/problem.h"

namespace ricochet {

/// The problem without constraints, for solvers that take none: the objective plus `weight` > 0
/// times the sum of the violations, of an equality its size: the exact l1 penalty (Nocedal and
/// Wright, Numerical Optimization, section 17.2). Of the same name, and judged, as before, by true
/// objective and true violation. Where it has derivatives, they are one-sided at the kinks. It has
/// no residuals: it is no sum of squares.
Problem penalised(const Problem& problem, double weight);

}  // namespace ricochet
