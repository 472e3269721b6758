#pragma once

#include "ricochet/solver.h"

namespace ricochet {

/// Bisection, as an engineer would do it by hand: if the end of the box with the best objective is
/// infeasible, halves the interval between it and the other end until it encloses the limit of the
/// feasible set. For one variable, with inequalities. The start is the first point tried between
/// the ends; if there are several limits, another start may find another one.
Solver bisection();

}  // namespace ricochet
