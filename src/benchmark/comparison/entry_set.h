#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/analysis/cell_results.h"
#include "src/benchmark/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// A solver-formulation pair: the solver in the formulation that accepts most problems of the set;
/// of several such formulations, the one with the largest share solved, then the fewest
/// evaluations.
struct Entry {
  std::string solver, formulation;
  std::vector<const CellResult*> results;  ///< one for each problem, in the set's order
};

/// Entries that can be compared: on the problems of one family in a part of the plan, with one
/// budget, without perturbations, with a gradient at the price of n evaluations.
struct EntrySet {
  std::string family;  ///< as named in the report
  std::size_t part = 0;
  std::int64_t budget = 0;  ///< evaluations per variable
  bool largest = false;     ///< true if no part has a larger budget for any of its problems
  std::vector<std::size_t> problems;
  std::vector<Entry> entries;  ///< entries that take all of the problems, by name
  std::vector<Entry> partial;  ///< entries that take only some of the problems, by name

  /// Returns true if its entries are compared with each other: it has the largest budget, and
  /// several entries and problems.
  bool compared() const { return largest && entries.size() > 1 && problems.size() > 1; }

  /// Returns true if an entry that takes all problems solved one.
  bool any_solved() const;
};

/// The sets of entries of a campaign, by part, family and budget. The results outlive them.
std::vector<EntrySet> entry_sets_of(const Campaign& campaign,
                                    const std::vector<CellResult>& results,
                                    const std::vector<ReportedPart>& parts);

/// Whether joint_entry_set joins it: it has the largest budget, and at least half of all solvers
/// take all of its problems.
bool is_joined(const Campaign& campaign, const EntrySet& set);

/// Joins the sets with the largest budgets whose problems at least half of all solvers take. The
/// family of the joint set is "all", its budget is 0. With fewer than two such sets it has no
/// problems.
EntrySet joint_entry_set(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// Calls `use` for each entry of a set, also those that take only some of its problems.
template <class Use>
void each_entry(const EntrySet& set, const Use& use) {
  for (const auto* entries : {&set.entries, &set.partial}) {
    for (const Entry& entry : *entries) use(entry);
  }
}

/// Calls `tell` for each set that `takes` and collects what it returns.
template <class Takes, class Tell>
report::Json of_sets(const std::vector<EntrySet>& sets, const Takes& takes, const Tell& tell) {
  report::Json all = report::Json::array();
  for (const EntrySet& set : sets) {
    if (takes(set)) all.push_back(tell(set));
  }
  return all;
}

/// Of the sets whose entries are compared.
template <class Tell>
report::Json of_compared(const std::vector<EntrySet>& sets, const Tell& tell) {
  return of_sets(
      sets, [](const EntrySet& set) { return set.compared(); }, tell);
}

/// Of those of which a run solved its problem, too: no other costs can be compared.
template <class Tell>
report::Json of_solved(const std::vector<EntrySet>& sets, const Tell& tell) {
  return of_sets(
      sets, [](const EntrySet& set) { return set.compared() && set.any_solved(); }, tell);
}

/// The results of one entry on one problem, by the returned points; all runs have the same weight.
struct OnProblem {
  double evaluations;     ///< mean, per variable; a run without evaluations counts as 1
  double seconds;         ///< mean
  double share;           ///< solved
  double optimality_gap;  ///< median; infinite if most runs returned no feasible point
};
OnProblem on_problem(const Campaign& campaign, const CellResult& result);

/// Geometric mean of costs >= 0; a cost below 1e-6 counts as 1e-6.
double mean_cost(const std::vector<double>& costs);

}  // namespace ricochet::studies::comparison
