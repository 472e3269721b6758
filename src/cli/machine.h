#pragma once

#include <string>

#include "src/cli/quiet_speed_request.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

/// Prints a machine file to start from, with the meaning of every number. Returns the exit code.
int new_machine();

/// Prints a machine's file with its default values, each with unit, range and meaning, and warns of
/// probable mistakes. Returns the exit code.
int check_machine(const SceneChoice& choice);

/// Writes the page of advice into a folder and prints the answer. Returns the exit code.
int advise_machine(const SceneChoice& choice, const QuietSpeedRequest& asked,
                   const std::string& folder);

}  // namespace ricochet::cli
