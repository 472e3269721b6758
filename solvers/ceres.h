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

/// "ceres-trust-region": the Levenberg-Marquardt method of Ceres in the unit cube, with dense QR
/// decomposition, in one thread. Ends at once if the residuals at the start are not finite. Ceres
/// projects its steps onto the box and can stop short of an optimum on a bound:
/// https://github.com/ceres-solver/ceres-solver/issues/187.
Solver ceres_least_squares();
inline constexpr Capabilities ceres_least_squares_capabilities = {.needs_residuals = true};

/// With Ceres's own options "initial_trust_region_radius", "function_tolerance" and
/// "parameter_tolerance".
AdjustableSolver adjustable_ceres_least_squares();

}  // namespace ricochet
