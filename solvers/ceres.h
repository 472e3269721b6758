#pragma once

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// "ceres-lbfgs": the limited-memory BFGS line search of Ceres. It takes no bounds, so it works on
/// y in R^n with x = middle + half width * sin(y). On a bound the slope of this map is 0, so a
/// start there is moved inside by 5e-4 of the box.
Solver ceres_lbfgs();
inline constexpr Capabilities ceres_lbfgs_capabilities = {.derivatives =
                                                              Capabilities::Order::gradient};

/// With Ceres's own options "max_lbfgs_rank", "function_tolerance", "gradient_tolerance",
/// "parameter_tolerance", "line_search_sufficient_function_decrease" and
/// "line_search_sufficient_curvature_decrease".
AdjustableSolver adjustable_ceres_lbfgs();

}  // namespace ricochet
