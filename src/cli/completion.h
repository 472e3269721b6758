#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// A script for "bash", "zsh" or "fish" that completes the commands of the description, their
/// options, and the names of problems, families, solvers, plans and cases.
std::string completion(const std::string& shell, const report::Json& commands);

}  // namespace ricochet::cli
