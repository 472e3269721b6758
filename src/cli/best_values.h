#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ricochet::cli {

struct BestValuesOptions {
  std::string problems;           ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< start no search after this time
  std::int64_t budget = 50'000;   ///< of each search, evaluations a variable
  std::string out = "reports/best-values/best_known.toml";
  std::string from;           ///< if not empty: take values from the runs of this store instead
  std::string hard_machines;  ///< if not empty: search for hard machines, and write them here
};

/// Searches for the best value of every problem, resumes where it was stopped, and writes the
/// values to a file; or takes better values from a store; or searches for hard machines. Returns
/// the exit code.
int best_values(const BestValuesOptions& options);

}  // namespace ricochet::cli
