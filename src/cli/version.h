#pragma once

#include <string>

namespace ricochet::cli {

/// What --version prints: version, commit, compiler, and the libraries that this was built with.
std::string version();

}  // namespace ricochet::cli
