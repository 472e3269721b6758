#pragma once

#include "solvers/adjustable_solver.h"
#include "src/core/solver.h"

namespace ricochet {

/// "ceres-lbfgs": the limited-memory BFGS line search of Ceres. Its line search knows no bounds, so
/// it works on y in R^n with x = middle + half width * sin(y); a start on a bound, where that has
/// no slope, is moved inside by 5e-4 of the box. Needs derivatives, takes no constraints.
Solver ceres_lbfgs();

/// With Ceres's own options "max_lbfgs_rank", "function_tolerance", "gradient_tolerance",
/// "parameter_tolerance", "line_search_sufficient_function_decrease" and
/// "line_search_sufficient_curvature_decrease".
AdjustableSolver adjustable_ceres_lbfgs();

}  // namespace ricochet
