#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/analysis/results.h"
#include "src/experiment/campaign.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Why a problem tells nothing about solvers.
enum class Silence {
  easy,     ///< random search solves it within 20 evaluations
  unsolved  ///< no run solved it
};

/// A part of a campaign's plan, as it is reported.
struct ReportedPart {
  std::size_t part;
  /// The conditions that are compared within it: no perturbation, and a gradient at the measured
  /// price, else at n; if it has none of these, its first perturbation or price.
  Conditions usual;
  /// The same at the price n, as by differences, if it has both prices.
  std::optional<Conditions> by_differences = {};
  /// Names of its families; if an earlier part has a family too, the part's name or number is
  /// added.
  std::map<std::string, std::string> families = {};
  /// Families, by their own names, that an earlier part has too and in which this one varies
  /// perturbations, prices or smoothing parameters: they are not rated a second time.
  std::set<std::string> asked_again = {};
  /// The parts with the same problems that have several seeds (may be this one), or drawn machines.
  std::optional<std::size_t> repetition = {}, drawn = {};
  /// Problems that tell nothing about solvers, in a family of which others do: see set_silent().
  std::map<std::size_t, Silence> silent = {};
};

/// The price at which gradients are charged where entries are compared: "measured", else "n", else
/// the first of the part.
std::string usual_price(const PlanPart& part);

/// The name of a part of a plan: its own, or "part-1" after its number, counted from 0.
std::string name_of_part(const PlanPart& part, std::size_t number);

/// Returns the parts without those that only repeat another one with more seeds or on drawn
/// machines, and without those that relocate the optimum.
std::vector<ReportedPart> reported_parts(const Campaign& campaign);

}  // namespace ricochet::studies::comparison

namespace ricochet::studies {

/// What is compared; patterns are shell patterns, separated by commas.
struct ComparisonOptions {
  std::string problems;  ///< names of problems; empty: those of the default comparison
  std::string solvers = "*";
  /// Solvers that are included whatever the patterns select: names, or files and programs of the
  /// user; see solvers/outside/outside.h.
  std::vector<std::string> added_solvers = {};
  std::string formulations = "*";
  std::vector<std::int64_t>
      budgets;  ///< evaluations per variable; empty: those of the default comparison
  std::vector<double> smoothings;  ///< of surrogates, in addition to the default one
  int instances = 15;
  Limits limits;  ///< of every run
  /// Text of a machine file: its problems of one variable, whose names end in -scene, all if
  /// `problems` is empty; empty: the problems of the suite.
  std::string scene = {};
};

/// Returns the plan for these options. Throws InputError if a pattern matches nothing.
Plan comparison_plan(const ComparisonOptions& options, bool quick, const Catalogue& catalogue);

}  // namespace ricochet::studies

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
/// budget, under its usual conditions.
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

/// The clusters of an entry's problems, in their order.
std::vector<std::string> clusters_of(const Campaign& campaign, const Entry& entry);

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
