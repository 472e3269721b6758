#pragma once

#include <string>
#include <vector>

#include "src/app/command_line.h"
#include "src/experiment/campaign.h"
#include "src/experiment/plan.h"

namespace ricochet::cli {

/// Adds the plan that a command takes, for plan_named().
void add_plan_file(CLI::App* command, std::string& plan);

/// Returns the plan of a file, or one of the plans that are included.
Plan plan_named(const std::string& name);

/// The programs and shared libraries that a plan names as solvers, each once, in their order.
/// Starts none. Throws InputError for one that does not exist.
std::vector<std::string> programs_of(const Plan& plan);

/// The catalogue of the suite that starts no program: see outside::unstarted_solver.
Catalogue catalogue_that_starts_nothing();

/// Says which programs will be started. Throws InputError, which names `origin`, if they are not
/// allowed: a file from elsewhere must not start programs unasked.
void announce_programs(const std::vector<std::string>& programs, bool allowed,
                       const std::string& origin);

}  // namespace ricochet::cli
