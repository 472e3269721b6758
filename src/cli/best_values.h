#pragma once

#include <optional>
#include <string>

namespace ricochet::cli {

struct BestValuesOptions {
  std::string questions;          ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< begin nothing later
  std::string out = "reports/best-values/best_known.toml";
  std::string hard_machines;  ///< where not empty, hard machines are looked for instead, into here
};

/// Looks for the best value of every question, goes on from where it was stopped, and writes them
/// to a file; or looks for hard machines. Returns the exit code.
int best_values(const BestValuesOptions& options);

}  // namespace ricochet::cli
