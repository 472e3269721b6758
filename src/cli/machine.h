#pragma once

#include <string>

#include "src/cli/quiet_speed_request.h"

namespace ricochet::cli {

/// Prints the file of a machine to start from, with what every number means. Returns the exit code.
int new_machine();

/// Prints a machine's file with every field that it leaves out, each with unit, range and meaning,
/// and what looks like a slip. Returns the exit code.
int check_machine(const std::string& scene_file);

/// Writes the page of advice into a folder and prints the answer. Returns the exit code.
int advise_machine(const std::string& scene_file, const QuietSpeedRequest& asked,
                   const std::string& folder);

}  // namespace ricochet::cli
