#pragma once

#include <vector>

#include "src/core/solver.h"

namespace ricochet {

/// Every solver there is, each under a name of its own.
std::vector<Solver> all_solvers();

}  // namespace ricochet
