#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// A script that completes the commands of the description and their options, for "bash", "zsh" or
/// "fish".
std::string completion(const std::string& shell, const report::Json& commands);

}  // namespace ricochet::cli
