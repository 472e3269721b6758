#pragma once

#include <string>
#include <vector>

namespace ricochet::cli {

struct ListOptions {
  std::string what;                   ///< cases, problems, solvers or interpretations
  std::string scene_file;             ///< problems of this machine; empty for the paper's
  std::vector<std::string> settings;  ///< of --set
  std::string family;                 ///< problems of this family; empty for all
  std::string solver;  ///< problems that it accepts in some formulation; empty for all
  bool json = false;
};

/// Lists cases, problems, solvers or interpretations. Returns the exit code.
int list(const ListOptions& options);

}  // namespace ricochet::cli
