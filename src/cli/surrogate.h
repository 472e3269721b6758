#pragma once

#include <string>

namespace ricochet::cli {

struct SurrogateOptions {
  bool quick = false;
  std::string out = "reports/surrogate";
};

/// Computes whether the surrogate can be trusted and writes the report. Returns the exit code.
int surrogate(const SurrogateOptions& options);

}  // namespace ricochet::cli
