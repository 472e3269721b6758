#pragma once

#include <map>
#include <string>

#include "src/statistics/fisher_exact_test.h"
#include "src/studies/contest/group.h"

namespace ricochet::studies::contest {

/// A share with Wilson's interval: share, lower, upper.
report::Json share_data(const Share& share);

/// Runs solved of all questions of a group with the largest budget: by solver, then by form.
std::map<std::string, std::map<std::string, Share>> shares_by_form(
    const ContestPlan& plan, const std::vector<Standing>& standings, const Group& group);

/// Counts the runs of a standing, and those that solved.
void add_runs(Share& share, const Standing& standing);

}  // namespace ricochet::studies::contest
