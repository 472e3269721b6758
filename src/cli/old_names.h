#pragma once

#include <string>

namespace ricochet::cli {

/// Returns "--questions is now called --problems" for a command, an option or a value that had
/// another name in version 1 of the suite; empty for any other word.
std::string renaming_of(const std::string& word);

}  // namespace ricochet::cli
