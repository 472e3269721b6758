#pragma once

#include <optional>
#include <string>

namespace ricochet::cli {

struct CertifyOptions {
  std::string problems;           ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< begin nothing later
  std::string out = "reports/certify/best_known.toml";
};

/// Looks for the best value of every problem, goes on from where it was stopped, and writes them to
/// a file. Returns the exit code.
int certify(const CertifyOptions& options);

}  // namespace ricochet::cli
