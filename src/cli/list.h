#pragma once

#include <string>

namespace ricochet::cli {

/// Prints what there is of "cases", "questions" (or "problems", as they were called), "solvers" or
/// "readings"; with a scene file, if its name is not empty, those of that machine. Returns the exit
/// code.
int list(const std::string& what, const std::string& scene_file, bool json);

}  // namespace ricochet::cli
