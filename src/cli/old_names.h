#pragma once

#include <string>

#include "src/cli/command_line.h"

namespace ricochet::cli {

/// Returns "--questions is now called --problems" for a command, an option or a value that had
/// another name in version 1 of the suite; empty for any other word.
std::string renaming_of(const std::string& word);

/// Adds the old name of a command, hidden, which fails with an error that gives the new one.
void add_moved(CommandLine& line, const std::string& command, const std::string& now);

}  // namespace ricochet::cli
