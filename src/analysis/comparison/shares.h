#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/report/results.h"
#include "src/report/table.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Adds the failure atlas to a page: a table "atlas", for each machine and perturbation the share
/// of runs that solved their problem, with Wilson's interval, the outcomes of the other runs, and a
/// command that repeats one of them; and parts "outcomes", a map for each kind of outcome.
void add_atlas(const Campaign& campaign, const std::vector<CellResult>& results,
               report::Results& page);

/// The runs that failed with an error or were ended from outside: a row for each cell and kind of
/// failure, with the command that repeats the first of them.
Table failure_table(const std::vector<RatedPart>& parts);

/// Effect of the formulation on a solver: for every solver that takes several formulations, the
/// success rate in each with the largest budget.
Table formulation_table(const Comparison& comparison, const Group& group);

/// Surrogate bias: the distance from the optimum of the surrogate to the best point, for every
/// smoothing parameter that is used. A solver that converges to the surrogate's optimum cannot come
/// closer.
Table ceiling_table(const Comparison& comparison, const Group& group);

/// What separates the entries that solve a problem from those that do not, with the largest budget.
struct Separation {
  std::size_t entries, solving;  ///< solving: in at least half of their runs
  /// "gradients: 80 %, without: 20 %": the property of entries (a formulation, needing gradients,
  /// being stochastic) of least p-value of the rank-sum test of the success rates with and without
  /// it, if it is below 5 % after Holm's correction over the properties. Entries of one solver are
  /// alike: the test takes them as independent.
  std::optional<std::string> by;
};
Separation separation_of(const Comparison& comparison, std::size_t problem);

/// Solved runs and all runs on the problems of a group with the largest budget: by solver, then by
/// formulation.
std::map<std::string, std::map<std::string, Share>> shares_by_formulation(
    const Comparison& comparison, const Group& group);

/// Adds the runs of a result, and those that solved the problem.
void add_runs(Share& share, const CellResult& result);

/// "1 variable", "2 to 8 variables": of these problems.
std::string variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems);

}  // namespace ricochet::studies::comparison
