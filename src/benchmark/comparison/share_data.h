#pragma once

#include <map>
#include <string>

#include "src/benchmark/comparison/group.h"
#include "src/benchmark/statistics/fisher_exact_test.h"

namespace ricochet::studies::comparison {

/// A share with Wilson's interval: share, lower, upper.
report::Json share_data(const Share& share);

/// Solved runs and all runs on the problems of a group with the largest budget: by solver, then by
/// formulation.
std::map<std::string, std::map<std::string, Share>> shares_by_formulation(
    const Comparison& comparison, const Group& group);

/// Adds the runs of a result, and those that solved the problem.
void add_runs(Share& share, const CellResult& result);

/// The number of variables of these problems: `variables`, such as "2 to 8", and `several`.
report::Json variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems);

}  // namespace ricochet::studies::comparison
