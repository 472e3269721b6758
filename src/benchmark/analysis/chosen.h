#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"

namespace ricochet::comparison {

// Patterns are shell patterns separated by commas: see patterns.h.

/// The problems whose names match and whose best values are known. Throws InputError, naming
/// `option`, if there is none.
std::vector<Problem> chosen_problems(const std::vector<Problem>& all, const std::string& patterns,
                                     const std::string& option);

/// The solvers whose names match. Throws InputError if there is none.
std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option);

}  // namespace ricochet::comparison
