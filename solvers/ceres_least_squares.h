#pragma once

#include "solvers/adjustable_solver.h"
#include "src/core/solver.h"

namespace ricochet {

/// "ceres-trust-region": the Levenberg-Marquardt method of Ceres in the unit cube, its steps by a
/// dense QR decomposition, in one thread. Needs residuals, takes no constraints. A start where they
/// are not finite ends at once. Ceres projects its steps onto the box, and can stop short of an
/// optimum on a bound: https://github.com/ceres-solver/ceres-solver/issues/187.
Solver ceres_least_squares();

/// With Ceres's own options "initial_trust_region_radius", "function_tolerance" and
/// "parameter_tolerance".
AdjustableSolver adjustable_ceres_least_squares();

}  // namespace ricochet
