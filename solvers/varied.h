#pragma once

#include <string>
#include <vector>

#include "solvers/adjustable_solver.h"

namespace ricochet {

/// Every solver of this build that has options.
std::vector<AdjustableSolver> adjustable_solvers();

/// The solver `of` under another name and with these options instead of its defaults; its version
/// lists them. Throws InputError if there is no such solver with options, for an unknown option,
/// and for a value that is not allowed.
Solver varied(const std::string& of, const std::string& name, const GivenOptions& given);

/// The options of a solver. Throws InputError if there is no such solver with options.
std::vector<SolverOption> options_of(const std::string& solver);

}  // namespace ricochet
