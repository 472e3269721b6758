#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "src/research/best_values/search.h"

namespace ricochet::studies::best_values {

/// Which best values are searched for, and for how long.
struct Plan {
  std::string problems;  ///< a shell pattern, or a part of the name; empty: all
  double seconds = std::numeric_limits<double>::infinity();  ///< no search is begun later
  Effort effort = {};
};

/// The result of a search.
struct Outcome {
  std::size_t wanted = 0;      ///< problems of the plan
  std::size_t finished = 0;    ///< of those, in this call or earlier
  std::size_t improved = 0;    ///< better than the known value, or new
  std::size_t infeasible = 0;  ///< no feasible point evaluated
};

/// Returns true if the name contains the pattern, or matches it as in a shell if it has * ? or [.
bool matches(const std::string& name, const std::string& pattern);

/// Searches for the best values of the problems, in parallel, and writes them to the file of
/// best_known.h once all are complete. Until then finished values are kept in "<file>.part", so
/// that an interrupted call can be resumed; values from calls for other problems are kept there
/// too. Known values, in the file or in the program, are evaluated again at their points, and stay
/// unless a better one is found; their provenance says how many searches agree. Throws InputError
/// if a pattern matches nothing, or if a file cannot be read or written.
Outcome find_best_values(const std::vector<Problem>& problems, const Plan& plan,
                         const std::filesystem::path& file);

}  // namespace ricochet::studies::best_values
