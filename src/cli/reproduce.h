#pragma once

#include <string>

namespace ricochet::cli {

struct ReproduceOptions {
  bool quick = false;
  std::string out = "reports/reproduction";
};

/// Computes everything and writes the report. Returns the exit code.
int reproduce(const ReproduceOptions& options);

}  // namespace ricochet::cli
