#pragma once

#include <string>
#include <vector>

#include "src/cli/command_line.h"

/// What a command line was probably meant to say, for its error. Each is empty if nobody can tell.
namespace ricochet::cli {

/// For an argument that the command does not expect, such as a case without its option:
/// "C1: give it as --case C1".
std::string hint_at_argument(const CLI::App& command, const std::string& argument);

/// For the first option with a value that is none of its choices, or is a number with a unit:
/// "--omega 60rpm: must be a number, without a unit, in rad/s: 6.28319".
std::string hint_at_value(const CLI::App& command);

/// For arguments that are missing: how the command is called.
std::string hint_at_call(const CLI::App& command, const std::string& path);

/// The values in the braces of an option's type.
std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace ricochet::cli
