#pragma once

#include <vector>

#include "solvers/adjustable_solver.h"
#include "solvers/settings.h"
#include "src/core/solver.h"

namespace ricochet {

/// "ipopt": the interior-point method of Waechter and Biegler (Math. Program. 106 (2006) 25-57) in
/// the unit cube, with a limited-memory Hessian. Needs derivatives. Ipopt is not thread-safe, so
/// one solve at a time runs in a process and others wait; waiting costs a run no processor time.
Solver ipopt(Settings settings);

/// "ipopt-exact": the same with its own settings and the exact Hessian of the Lagrangian. Needs
/// second derivatives, too.
Solver ipopt_exact();

/// "ipopt", "ipopt-tuned" and "ipopt-exact" with any of Ipopt's own options, numbers and words, by
/// its names, but for those that choose the Hessian, write files, or end a run by the clock.
std::vector<AdjustableSolver> adjustable_ipopt();

}  // namespace ricochet
