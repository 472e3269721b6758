#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/experiment/store.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Adds which solver is ahead at which cost of a simulation, with a gradient that is free, at its
/// measured price and at n evaluations: table "break-even" with the ranges of cost, and the
/// value "here", the cost of a simulation as it is [s]. The runs are those at the usual price; only
/// their requests are priced differently.
void add_break_even(const Campaign& campaign, const EntrySet& set, report::Results& page);

/// Speed against accuracy: a row for each solver, in its best formulation, for each family and
/// budget in a part of the plan:
///
///    family (as in the rest of the report), part (from 1), budget (evaluations per variable),
///    largest (no budget is larger), solver, kind, formulation, problems, complete (it takes all
///    problems that any solver takes there), runs
///    evaluations   per variable, until a run solved its problem, or all of them: mean over the
///                  runs of a problem, geometric mean over problems
///    seconds       of processor time, the same mean
///    share, lower, upper   of runs that solved, mean over problems; the interval is over problems,
///                  or over the runs that differ if there is one problem
///    on_front, on_time_front   no complete one is better in evaluations (seconds) and share
///
/// Rows of the family "all", whose budget is missing, join the families of
/// which at least half of all solvers take all problems, with the largest budgets.
Table speed_accuracy_table(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// The success rate over evaluations or seconds, a dot for each complete row of one family and
/// budget, of which there must be one, with the Pareto front.
report::Chart speed_accuracy_chart(const Table& of_family, bool by_time);

/// Of each kind of solvers on one family and budget the one that solves most, the best kind first:
/// kind, solvers (of the kind), best, and its success rate with the interval.
Table kind_table(const Table& of_family);

/// Whether the paper's algorithm is better than random search there, by their intervals, and which
/// of its variants solves most; nothing if one of them does not take all problems.
std::optional<std::string> paper_algorithm_sentence(const Table& of_family);

/// How many solvers are on the front, and how many more are statistically tied with its most
/// accurate.
std::string front_sentence(const Table& of_family);

/// Adds the effects of perturbations on solvers, by family, with the largest budget. Each solver is
/// in the formulation that does best over all perturbations together; "plain" uses the same cells
/// as the perturbation. Table "perturbations", a row for each: means over solvers with and without
/// it, the number of solvers that it harms significantly, the most harmed one, and the one that
/// solves most under it; table "perturbation-rates" and chart "perturbations": the success rates;
/// table "outcomes": how the runs ended, see kind_of_end(). Returns false, with nothing added, if
/// the campaign has no perturbation but "plain".
bool add_perturbations(const Campaign& campaign, const std::vector<CellResult>& results,
                       report::Results& page);

/// Leaves out the results of hazardous problems, and the parts of the plan that have no other,
/// unless there are no others: they have a section of their own, and no share in rankings.
void set_pathological_apart(const Campaign& campaign, std::vector<CellResult>& results,
                            std::vector<ReportedPart>& parts);

/// Adds how runs on hazardous problems ended, with the largest budget and without perturbations:
/// solved, spent (the budget), ended (before), threw, killed or crashed. Table "pathological": a
/// row for each problem with the number of runs of each ending, and of those that evaluated a point
/// that solves it (found); "pathological-solvers": a row for each solver; the value
/// "pathological-runs": all of them in a sentence. Returns false if there are no such runs.
bool add_pathological(const Campaign& campaign, const std::vector<CellResult>& results,
                      report::Results& page);

/// Adds how the user's solvers did beside the others: table "own-solvers", a row for each of them
/// and each family with its largest budget: the success rate of its entry, with its interval, the
/// number of other solvers that solve fewer and more of the problems that both take (if these are
/// at least half of the family's), and on how many of these the difference is significant:
/// Wilcoxon's signed-rank test over problems, with Holm's correction over the solvers of the
/// family, at 5 %. Table "own-totals", a row for each: the problems that it solved in most of its
/// runs.
void add_own_solvers(const Campaign& campaign, const std::vector<EntrySet>& sets,
                     const std::vector<Solver>& suite, report::Results& page);

/// Adds the bias of entries towards the ends or the middle of the box: table "relocated-optima",
/// the share of runs that each solves of the relocated-optimum variants with
/// the best point at the lower end, in the middle and at the upper end, for every part of the plan
/// that relocates the optimum; the value "relocated" says what the problems are.
void add_relocated_optima(const Campaign& campaign, const std::vector<CellResult>& results,
                          report::Results& page);

/// The page of the families on a grid of machines, or of fidelities: parts "families", one for each
/// that differs in some factor, with chart "known", the best known values over the factors, chart
/// "landscape", the true objective of problems of one variable without constraints, a row for each
/// machine, and table "levels", who is first at each level of a factor.
report::Results machines_page(const std::vector<RatedPart>& parts);

/// Returns the name of a factor's level: a number, or the name of a fidelity.
std::string level_name(const std::string& factor, double level);

/// How the cost of an entry changed from one store to another, over the problems that both have.
/// The cost on a problem is the penalised one: evaluations until solved by the returned point, mean
/// over the instances and seeds that both have; a run that did not solve it counts as ten budgets.
struct EntryChange {
  std::string solver, formulation, perturbation, gradient_price;
  std::string version, other_version;  ///< of the solver
  int problems = 0;
  int cheaper = 0, dearer = 0;  ///< problems on which the second store's cost is lower, is higher
  double ratio = 1;             ///< of the costs, second to first: geometric mean
  /// Of Wilcoxon's signed-rank test of the logarithms of the ratios, with Holm's correction over
  /// all entries.
  double p_value = 1;

  bool same() const { return cheaper == 0 && dearer == 0; }
  bool sure() const { return p_value < 0.05; }
};

struct EntryChanges {
  std::vector<EntryChange> entries;         ///< least p-value first, then by name
  std::vector<std::string> other_problems;  ///< names that both have, but with different hashes
};

/// Pairs the runs of two stores by entry, problem and the largest budget that both have. Throws
/// InputError if a store is damaged.
EntryChanges entry_changes(const Store& first, const Store& second);

}  // namespace ricochet::studies::comparison
