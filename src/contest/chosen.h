#pragma once

#include <string>
#include <vector>

#include "src/core/question.h"
#include "src/core/solver.h"

namespace ricochet::contest {

// Patterns are those of a shell, with commas between: see patterns.h.

/// The questions whose names fit and whose best values are known. Throws InputError where there is
/// none, naming `option`.
std::vector<Question> chosen_questions(const std::vector<Question>& all,
                                       const std::string& patterns, const std::string& option);

/// The solvers whose names fit. Throws InputError where there is none.
std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option);

}  // namespace ricochet::contest
