#pragma once

#include <string>
#include <vector>

#include "src/benchmark/experiment/campaign/campaign.h"

namespace ricochet::cli {

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
