#pragma once

#include <vector>

#include "src/core/solver.h"

namespace ricochet {

/// The solvers of NLopt, "nlopt-...", each accepting what NLopt 2.7.1 can do with it. All work in
/// the unit cube. Local ones begin with a step of a quarter of the box and end at a step of 1e-8 of
/// it, to be started again elsewhere.
///
/// A number that is not finite counts as +infinity for global solvers, or as the worst so far, and
/// ends a local one: several of those would report success, or never return.
std::vector<Solver> nlopt_solvers();

}  // namespace ricochet
