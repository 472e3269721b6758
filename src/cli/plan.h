#pragma once

#include <string>

#include "src/benchmark/experiment/campaign/plan.h"
#include "src/cli/command_line.h"

namespace ricochet::cli {

/// Adds the plan that a command takes, for plan_named().
void add_plan_file(CLI::App* command, std::string& plan);

/// Returns the plan of a file, or one of the plans that are included.
Plan plan_named(const std::string& name);

}  // namespace ricochet::cli
