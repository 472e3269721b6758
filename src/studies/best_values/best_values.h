#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "src/studies/best_values/search.h"

namespace ricochet::studies::best_values {

/// Which best values are looked for, and how long.
struct Plan {
  std::string questions;  ///< a pattern of the shell, or a part of the name; empty: all
  double seconds = std::numeric_limits<double>::infinity();  ///< nothing is begun later
  Effort effort = {};
};

/// What came of it.
struct Outcome {
  std::size_t wanted = 0;      ///< questions of the plan
  std::size_t finished = 0;    ///< of those, now and before
  std::size_t improved = 0;    ///< better than what was known, or new
  std::size_t infeasible = 0;  ///< no feasible point found
};

/// Whether the name holds the pattern, or matches it as the shell does where it has * ? or [.
bool matches(const std::string& name, const std::string& pattern);

/// Looks for the best values of the questions, in parallel, and writes them to the file of
/// best_known.h once all are there. What is finished is kept in "<file>.part" until then, so that a
/// call that was stopped goes on; what a call for other questions has kept there stays. Values that
/// are known already, in the file or in the program, are computed anew at their points, and stay
/// unless a better one was found. Throws InputError for a pattern that nothing matches, or a file
/// that cannot be read or written.
Outcome find_best_values(const std::vector<Question>& questions, const Plan& plan,
                         const std::filesystem::path& file);

}  // namespace ricochet::studies::best_values
