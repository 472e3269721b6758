#pragma once

#include <map>
#include <string>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Returns the failure atlas: for each machine and perturbation, the share of runs that solved
/// their problem, with Wilson's interval, the outcomes of the other runs, and a command that
/// repeats one of them. Also returns the largest budget of each problem.
report::Json atlas_data(const Campaign& campaign, const std::vector<CellResult>& results);

/// Returns the runs that failed with an error or were ended from outside: a row for each cell and
/// kind of failure, with the command that repeats the first of them.
report::Json failure_data(const ricochet::comparison::Comparison& comparison);

/// Effect of the formulation on a solver: for every solver that takes several formulations, the
/// success rate in each with the largest budget, by family.
report::Json formulation_data(const Comparison& comparison, const std::vector<Group>& groups);

/// Surrogate bias: the distance from the optimum of the surrogate to the best point, for every
/// smoothing parameter that is used. A solver that converges to the surrogate's optimum cannot come
/// closer.
report::Json ceiling_data(const Comparison& comparison, const std::vector<Group>& groups);

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

/// A sample of the problems of a campaign whose runs are complete, drawn within each family from
/// strata of difficulty: the share of its runs, over all entries, that did not solve a problem. A
/// row for each family of each part: the problems drawn (a share of them, but at least `least`),
/// their difficulties, and how far the order of the entries on them agrees with that on all
/// problems: see agreement_of(), null where it cannot be said. `leader`, the first entry on all,
/// with the share of its runs that solved and its P(best); `sample_leader`, the first on the
/// sample.
report::Json sample_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         double share, std::size_t least);

}  // namespace ricochet::studies::comparison
