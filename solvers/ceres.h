#pragma once

#include "src/core/solver.h"

namespace ricochet {

/// "ceres-lbfgs": the limited-memory BFGS line search of Ceres. Its line search knows no bounds, so
/// it works on y in R^n with x = middle + half width * sin(y); a start on a bound, where that has
/// no slope, is moved inside by 5e-4 of the box. Needs derivatives, takes no constraints.
Solver ceres_lbfgs();

}  // namespace ricochet
