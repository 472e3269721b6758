#pragma once

#include <optional>
#include <string>

namespace ricochet::cli {

struct BestValuesOptions {
  std::string problems;           ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< start no search after this time
  std::string out = "reports/best-values/best_known.toml";
  std::string hard_machines;  ///< if not empty: search for hard machines, and write them here
};

/// Searches for the best value of every problem, resumes where it was stopped, and writes the
/// values to a file; or searches for hard machines. Returns the exit code.
int best_values(const BestValuesOptions& options);

}  // namespace ricochet::cli
