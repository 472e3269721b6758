#pragma once

#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// The solvers of NLopt, "nlopt-...", each with the capabilities it has in NLopt 2.7.1. All work in
/// the unit cube. Local ones begin with a step of a quarter of the box and end at a step of 1e-8 of
/// it; they can then be restarted elsewhere.
///
/// A value that is not finite counts as +infinity or as the worst so far for global solvers, and
/// ends a local one: several local ones would report success or never return.
std::vector<Solver> nlopt_solvers();

/// The adjustable ones. Options: "population" of crs2, isres, esch and mlsl; of local solvers
/// "tolerance" and, if they take it, "initial_step", both as shares of the box, and the number of
/// "vectors" that quasi-Newton methods keep.
std::vector<AdjustableSolver> adjustable_nlopt();

}  // namespace ricochet
