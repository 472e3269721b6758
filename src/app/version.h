#pragma once

#include <string>

namespace ricochet::cli {

/// Returns the output of --version: version, commit, compiler, and the linked libraries.
std::string version();

}  // namespace ricochet::cli
