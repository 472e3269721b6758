#pragma once

#include <string>
#include <vector>

#include "ricochet/solver.h"

namespace ricochet {

/// Every solver of this build, with distinct names.
std::vector<Solver> all_solvers();

/// A solver that this build lacks, and the library that provides it.
struct MissingSolver {
  std::string solver;
  std::string library;
  Capabilities capabilities;
};

/// The solvers of libraries that were switched off or missing when ricochet was configured.
std::vector<MissingSolver> missing_solvers();

/// The solver with this name. Throws InputError, which begins with `asked_by`, e.g. "--solver", if
/// no solver has the name or this build lacks it.
Solver solver_named(const std::string& name, const std::string& asked_by = "solver");

}  // namespace ricochet
