#pragma once

#include <string>

#include "src/benchmark/experiment/campaign/plan.h"

namespace ricochet::cli {

/// Returns the plan of a file, or one of the plans that are included.
Plan plan_named(const std::string& name);

/// Prints a plan to start from.
int new_plan();

/// Prints what a plan would run and for how long, or what is wrong with it.
int check_plan(const std::string& plan, bool json);

/// Prints a script for the workload manager Slurm that runs a plan as this number of jobs and
/// merges their stores.
int slurm_script(const std::string& plan, int jobs);

}  // namespace ricochet::cli
