#pragma once

#include <string>
#include <vector>

#include "solvers/adjustable_solver.h"

namespace ricochet {

/// Every solver of this build of which something can be changed.
std::vector<AdjustableSolver> adjustable_solvers();

/// The solver `of` under another name and with these options in place of its own; its version tells
/// them. Throws InputError where no such solver has options, where it has none of a name, and for a
/// value that is not allowed.
Solver varied(const std::string& of, const std::string& name, const GivenOptions& given);

/// What can be changed about a solver. Throws InputError where no such solver has options.
std::vector<SolverOption> options_of(const std::string& solver);

}  // namespace ricochet
