#pragma once

#include <string>

namespace ricochet::cli {

/// Prints what there is of "cases", "problems", "solvers" or "readings". Returns the exit code.
int list(const std::string& what, bool json);

}  // namespace ricochet::cli
