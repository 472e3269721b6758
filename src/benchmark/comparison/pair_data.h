#pragma once

#include "src/benchmark/comparison/entry_set.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Compares in pairs the four entries of each set with the largest budgets that have the least
/// penalised cost. For the differences of their median optimality gaps, one for each problem, it
/// computes the Bayesian signed-rank test with the problem's tolerance (half a collision for a
/// count) as the region of practical equivalence. For the evaluations until their runs solve each
/// problem, it computes the Mann-Whitney rank-sum test with Holm's correction over all pairs and
/// problems of the set: on how many problems each is significantly faster. For the two cheapest it
/// also computes the difference of their attainment functions. Fields with one problem or one entry
/// are left out.
report::Json pair_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

}  // namespace ricochet::studies::comparison
