#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/rating.h"
#include "src/analysis/results.h"
#include "src/experiment/plan.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

struct Ranked {
  std::string solver;
  double rank;  ///< mean
};

/// The first entry, or "none" if it solved no run, and the ranked entries by name.
struct Order {
  std::string leader = "none";
  std::map<std::string, Ranked> entries;
};

/// Returns the order of ratings sorted best first; an entry is a solver-formulation pair.
Order order_of(const std::vector<Rating>& ratings);

/// Returns the order of those with this formulation; an entry is a solver.
Order order_in(std::vector<Rating> ratings, const std::string& formulation);

/// Agreement of two orders, over the entries in both: "entries", "solvers", "correlation"
/// (Kendall's), "lower" and "upper", by resampling solvers, since entries of one solver are alike.
/// Null for fewer than five solvers, or if all entries are tied.
report::Json agreement_of(const Order& a, const Order& b);

/// Is the ranking of the entries robust? Compares the order in every group with the one for other
/// seeds, for either half of the instances, for another formulation, for the largest budget instead
/// of the smallest, and for machines drawn around the problems' own, as far as the plan has parts
/// for it. `ratings` are those of the groups.
report::Json order_data(const Comparison& comparison, const std::vector<CellResult>& results,
                        const ReportedPart& part, const std::vector<Group>& groups,
                        const Ratings& ratings);

/// The families of a campaign with complete runs, by name, as its report names and ranks them.
std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results);

/// A row for each group with each budget, from the groups' data: its first entry, with `largest`
/// (the budget) and `random`, the expected running time [evaluations] of random search, the median
/// over the group's problems; null without one. No entry is named, and `easy` is true, where that
/// is at most 20: random search then meets a solution wherever 5 % of the box solve the problem.
report::Json leader_data(const Comparison& comparison, const std::vector<Group>& groups,
                         const report::Json& rows);

/// The problems whose best known value a run is below by more than the problem's tolerance: an
/// error of the suite, since no such run can be scored rightly. A row for each, with the best run
/// and the number of runs below.
report::Json beaten_data(const Campaign& campaign,
                         const std::vector<ricochet::comparison::CellResult>& results);

/// Rows of solver and library: those of `missing` that a part of the plan would have selected.
report::Json lacking_data(const Plan& plan, const std::vector<MissingSolver>& missing);

}  // namespace ricochet::studies::comparison
