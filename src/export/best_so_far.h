#pragma once

#include <vector>

#include "src/contest/outcome.h"

namespace ricochet::exports {

/// What stands for the regret as long as no feasible point was found, in formats that must have a
/// number. A regret that is not below it is left out as if it had not been found.
inline constexpr double nothing_feasible = 1e30;

/// How the best regret of a run fell, as readers of other suites take it: the first row is of
/// evaluation 1, the last of the run's last evaluation, evaluations rise, every regret but the
/// last row's is below the one before, and all are finite. A run that was charged nothing has one
/// row, of evaluation 1. Seconds are 0 where they are not known.
std::vector<contest::Step> best_so_far(const contest::Outcome& outcome);

}  // namespace ricochet::exports
