#pragma once

#include <vector>

#include "src/benchmark/comparison/group.h"

namespace ricochet::studies::comparison {

/// A row for each group with each budget, from the groups' data: its first entry, with `largest`
/// (the budget) and `random`, the expected running time [evaluations] of random search, the median
/// over the group's problems; null without one. No entry is named, and `easy` is true, where that
/// is at most 20: random search then meets a solution wherever 5 % of the box solve the problem.
report::Json leader_data(const Comparison& comparison, const std::vector<Group>& groups,
                         const report::Json& rows);

}  // namespace ricochet::studies::comparison
