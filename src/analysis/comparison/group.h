#pragma once

#include <string>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Problems of one family, which are rated together.
struct Group {
  std::string family;
  std::vector<std::size_t> problems;  ///< indices in the campaign

  bool has(const CellResult& result) const;
};

/// Returns the families of the problems that are compared, in the order of their first problems.
std::vector<Group> groups_of(const Comparison& comparison);

/// Ratings, best first, by either criterion.
struct BothRatings {
  std::vector<Rating> by_returned, by_evaluated;
};

/// For each group and each budget of the part.
using Ratings = std::vector<std::vector<BothRatings>>;
Ratings ratings_of(const Comparison& comparison, const std::vector<Group>& groups);

/// Returns, for each group, the ratings for each budget, its problems and, if there are few, all
/// results on them.
report::Json group_data(const Comparison& comparison, const std::vector<Group>& groups,
                        const Ratings& ratings);

/// Expected running time: evaluations per variable until the problem is solved, with restarts;
/// infinite if no run solved it.
double running_time(const Campaign& campaign, const CellResult& result);

/// Penalised cost of a run with this budget: evaluations until it solved its problem, at least 1;
/// if it did not, ten times the budget (PAR10; Lindauer, van Rijn and Kotthoff 2019,
/// doi:10.1016/j.artint.2018.10.004).
double penalised_cost(const Outcome& outcome, double budget);

/// That of a solver on a problem: per variable, mean over its runs.
double penalised_cost(const Campaign& campaign, const CellResult& result);

/// Returns the entries sorted by the geometric mean of their penalised costs, least first.
std::vector<const Entry*> cheapest_first(const Campaign& campaign, const EntrySet& set);

/// For every set of entries with the largest budgets, at least two entries and two problems:
/// performance profiles of the expected running times of the six entries with the least penalised
/// cost; and for all entries the share of problems within a factor of the least, the share on which
/// it is best, and the ratio of its penalised cost to the virtual best solver's.
report::Json profile_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

}  // namespace ricochet::studies::comparison
