#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// "ipopt": the interior-point method of Waechter and Biegler (Math. Program. 106 (2006) 25-57) in
/// the unit cube, with a limited-memory Hessian. Ipopt is not thread-safe, so a process runs one
/// solve at a time and others wait; waiting takes no processor time.
Solver ipopt(Settings settings);
inline constexpr Capabilities ipopt_capabilities = {.constraints = Capabilities::Constraints::all,
                                                    .derivatives = Capabilities::Order::gradient};

/// "ipopt-exact": the same with its own settings and the exact Hessian of the Lagrangian.
Solver ipopt_exact();
inline constexpr Capabilities ipopt_exact_capabilities = {
    .constraints = Capabilities::Constraints::all, .derivatives = Capabilities::Order::hessian};

/// "ipopt", "ipopt-tuned" and "ipopt-exact" with any of Ipopt's own options under its names, except
/// those that choose the Hessian, write files, or end a run by the clock.
std::vector<AdjustableSolver> adjustable_ipopt();

}  // namespace ricochet
