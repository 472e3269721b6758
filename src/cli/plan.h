#pragma once

#include <string>

#include "src/campaign/plan.h"

namespace ricochet::cli {

/// A file, or one of the plans that come along.
Plan plan_named(const std::string& name);

/// Prints a plan to start from.
int new_plan();

/// Says what a plan would run, and for how long, or what is wrong with it.
int check_plan(const std::string& plan, bool json);

/// Prints a script for the workload manager Slurm that carries a plan out as so many jobs and joins
/// what they stored.
int slurm_script(const std::string& plan, int jobs);

}  // namespace ricochet::cli
