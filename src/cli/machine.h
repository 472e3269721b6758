#pragma once

#include <string>

#include "src/cli/quiet_speed_request.h"

namespace ricochet::cli {

/// Prints a machine file to start from, with the meaning of every number. Returns the exit code.
int new_machine();

/// Prints a machine's file with its default values, each with unit, range and meaning, and warns of
/// probable mistakes. Returns the exit code.
int check_machine(const std::string& scene_file);

/// Writes the page of advice into a folder and prints the answer. Returns the exit code.
int advise_machine(const std::string& scene_file, const QuietSpeedRequest& asked,
                   const std::string& folder);

}  // namespace ricochet::cli
