#pragma once

#include <string>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/report/table.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// How a run ended: "solved", "budget spent", "gave up early" (it ended by itself), "evaluated, not
/// returned" (it evaluated a point that solves the problem, and returned another), "nothing
/// feasible", "threw", or "killed or crashed".
std::string kind_of_end(const Outcome& outcome, std::int64_t budget);

/// The runs that failed with an error or were ended from outside: a row for each cell and kind of
/// failure, with the command that repeats the first of them.
Table failure_table(const std::vector<RatedPart>& parts);

/// The formulations by the success rates of the solvers that are rated in several: how many these
/// are, mean and largest rate, and of how many it is the best formulation.
Table formulation_table(const std::vector<Rating>& ratings);

/// Surrogate bias: the distance from the optimum of the surrogate to the best point, for every
/// smoothing parameter that is used. A solver that converges to the surrogate's optimum cannot come
/// closer.
Table ceiling_table(const Comparison& comparison, const Group& group);

/// Adds the runs of a result, and those that solved the problem.
void add_runs(Share& share, const CellResult& result);

/// "1 variable", "2 to 8 variables": of these problems.
std::string variables_of(const Campaign& campaign, const std::vector<std::size_t>& problems);

}  // namespace ricochet::studies::comparison
