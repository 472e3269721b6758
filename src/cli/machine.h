#pragma once

#include <string>

namespace ricochet::cli {

/// Prints the file of a machine to start from, with what every number means. Returns the exit code.
int new_machine();

/// Prints a machine's file with every field that it leaves out, each with unit, range and meaning,
/// and what looks like a slip. Returns the exit code.
int check_machine(const std::string& scene_file);

}  // namespace ricochet::cli
