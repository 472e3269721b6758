#pragma once

#include <cstddef>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
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

using namespace ricochet::comparison;

/// How far two campaigns with complete runs order their entries alike: a row for each family of the
/// first that the second has, too, with the largest budget of each. `agreement`: see
/// agreement_of(), null where it cannot be said. `leader`: the first entry of the first campaign,
/// with `best`, its P(best) there, null for one problem, and `place`, its place in the second, null
/// if it is not ranked there. `other_leader`: the first of the second.
report::Json agreement_data(const Campaign& first, const std::vector<CellResult>& of_first,
                            const Campaign& second, const std::vector<CellResult>& of_second);

/// For every set of entries that is compared and every problem: the ratio of the evaluations of its
/// two best entries, and which of them solves it, as bars in ascending order.
report::Json log_ratio_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// What separates the entries that solve a problem from those that do not, with the largest budget:
/// `entries`, `solving` (in at least half of their runs), and `separates`, `those` and `others`: a
/// property of entries, and the success rates with and without it. The property is a formulation,
/// needing gradients, or being stochastic: that of least p-value of the rank-sum test of the
/// entries' success rates, if it is below 5 % after Holm's correction over the properties; else
/// null. Entries of one solver are alike: the test takes them as independent.
report::Json separation_data(const Comparison& comparison, std::size_t problem);

}  // namespace ricochet::studies::comparison
