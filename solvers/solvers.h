#pragma once

#include <string>
#include <vector>

#include "src/core/solver.h"

namespace ricochet {

/// Every solver of this build, each under a name of its own.
std::vector<Solver> all_solvers();

/// A solver that this build lacks, and the library that would bring it.
struct MissingSolver {
  std::string solver;
  std::string library;
};

/// Those of libraries that were switched off, or not there, when ricochet was configured.
std::vector<MissingSolver> missing_solvers();

}  // namespace ricochet
