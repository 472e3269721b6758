#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// Bisection, as an engineer would do it by hand: between the end of the box with the best
/// objective, if that is infeasible, and the other end, halves the interval that holds the limit of
/// the feasible points. Of one variable, with inequalities. The start is the first point tried
/// between the ends, so that another start finds another limit where there are several.
Solver bisection();

}  // namespace ricochet
