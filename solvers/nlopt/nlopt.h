#pragma once

#include <vector>

#include "solvers/adjustable_solver.h"
#include "src/core/solver.h"

namespace ricochet {

/// The solvers of NLopt, "nlopt-...", each accepting what NLopt 2.7.1 can do with it. All work in
/// the unit cube. Local ones begin with a step of a quarter of the box and end at a step of 1e-8 of
/// it, to be started again elsewhere.
///
/// A number that is not finite counts as +infinity for global solvers, or as the worst so far, and
/// ends a local one: several of those would report success, or never return.
std::vector<Solver> nlopt_solvers();

/// Those of which something can be changed: "population" of crs2, isres, esch and mlsl; of local
/// ones "initial_step", where they are told it, and "tolerance", both in parts of the box, and the
/// number of "vectors" that quasi-Newton methods keep.
std::vector<AdjustableSolver> adjustable_nlopt();

}  // namespace ricochet
