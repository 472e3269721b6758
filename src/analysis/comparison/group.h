#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/report/chart.h"
#include "src/report/table.h"

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

/// A part of the plan with its families, as the report names them, rated.
struct RatedPart {
  const ReportedPart* part;
  Comparison comparison;
  std::vector<Group> groups;  ///< without those that an earlier part has
  Ratings ratings;            ///< of the groups

  const std::vector<Rating>& most(std::size_t group) const {
    return ratings[group].back().by_returned;
  }
};

/// Campaign, results and parts must outlive them.
std::vector<RatedPart> rated_parts(const Campaign& campaign, const std::vector<CellResult>& results,
                                   const std::vector<ReportedPart>& parts);

/// The ratings of a family of so many problems, best first: solver, formulation, surrogate, takes,
/// problems, rank, best (P(best)), returned and found (success rates), share (of targets reached)
/// with its interval, never (problems solved in none of its runs).
Table rating_table(std::string name, const std::vector<Rating>& ratings, std::size_t problems);

/// The ECDF of runtimes of the best five entries, the paper's algorithm and, grey, other solvers.
report::Chart runtime_ecdf(const std::string& family, std::int64_t budget,
                           const std::vector<Rating>& ratings);

/// Success rate by the returned points of the first entries on each problem of the group, with the
/// largest budget.
report::Chart solved_map(const RatedPart& part, std::size_t group);

/// Every result on the problems of the group, for a group of few: problem, solver, formulation,
/// budget, success rates, expected running time, time, gap, each with its interval.
Table result_table(const RatedPart& part, const Group& group);

/// The problems of a group: name, variables, constraints, best_known, provenance, targets, easiest,
/// random (expected running time of random search), solving, entries, separates, hash; see
/// separation_of().
Table problem_table(const RatedPart& part, const Group& group,
                    const std::map<std::string, std::string>& hashes);

}  // namespace ricochet::studies::comparison
