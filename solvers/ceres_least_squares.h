#pragma once

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

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
