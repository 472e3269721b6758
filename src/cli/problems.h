#pragma once

#include <string>

namespace ricochet::cli {

struct ProblemsOptions {
  std::string scene_file;  ///< empty: the paper's cases
  std::string out = "reports/problems";
};

/// Writes an overview of the problems, and a page for each family. Returns the exit code.
int problems(const ProblemsOptions& options);

}  // namespace ricochet::cli
