#pragma once

#include <string>

namespace ricochet::cli {

struct ListOptions {
  std::string what;  ///< cases, questions (or problems, as they were called), solvers or readings
  std::string scene_file;  ///< of questions: of this machine; empty for the paper's
  std::string family;      ///< of questions: those of this family; empty for all
  std::string solver;      ///< of questions: those that it accepts in some form; empty for all
  bool json = false;
};

/// Prints what there is. Returns the exit code.
int list(const ListOptions& options);

}  // namespace ricochet::cli
