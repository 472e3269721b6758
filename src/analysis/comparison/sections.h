#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/solver.h"
#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/experiment/store.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Returns short questions with their answers, for a front page: a list of {problem, answer, links:
/// [{text, to}]}, from the data of the report with its pages. A question that the data cannot
/// answer is left out.
report::Json answers_data(const report::Json& all);

/// The first sentences of a comparison's report: which solver, how sure, on how many problems. Of
/// the rows of leader_data() those with the largest budgets.
std::string opening_of(const report::Json& leaders);

/// For each part and family: which entry is first, with the largest budget and without
/// perturbations, and how well the order of the entries agrees with that of the first setting:
/// - for each price of a gradient, if a part has several;
/// - for the surrogate of each smoothing parameter, the default one first;
/// - on the machines of each level of a factor that varies from machine to machine, such as the
///   fidelity of the simulation, the lowest level first.
report::Json change_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         const std::vector<ReportedPart>& parts);

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

/// For every set of entries that is compared, computes which solver is ahead at which cost of a
/// simulation, with a gradient that is free, at its measured price and at n evaluations: rows with
/// the ranges of cost, and the curves of every entry that is ahead somewhere. The runs are those at
/// the price n; only their requests are priced differently.
report::Json break_even_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// Speed against accuracy. `speed_accuracy` has a row for each solver, in its best formulation, for
/// each family and budget in a part of the plan:
///
///    family (as in the rest of the report), part (from 1), budget (evaluations per variable),
///    largest (no budget is larger), solver, formulation, problems, complete (it takes all problems
///    that any solver takes there), runs
///    evaluations   per variable, until a run solved its problem, or all of them: mean over the
///                  runs of a problem, geometric mean over problems
///    seconds       of processor time, the same mean
///    share, share_lower, share_upper   of runs that solved, mean over problems; the interval is
///                  over problems, or over the runs that differ if there is one problem
///    optimality_gap, optimality_gap_lower, optimality_gap_upper   median of the problems' medians,
///                  in the problem's unit; null if infinite; the interval is also null with fewer
///                  than 6 problems, or than 6 runs of one problem
///    on_front, on_time_front   no complete one is better in evaluations (seconds) and share
///
/// Rows of the family "all", whose budget and optimality gap are null, join the families of which
/// at least half of all solvers take all problems, with the largest budgets.
/// `speed_accuracy_charts` has the data of the charts: for each family the largest budgets, and for
/// all together also against seconds; `speed_accuracy_front` has the rows on their
/// Pareto fronts that solved some run.
report::Json speed_accuracy_data(const Campaign& campaign, const std::vector<EntrySet>& sets);

/// Effects of restitution, friction, disturbance and fidelity on solvers, for the families whose
/// machines differ in all of them, with the largest budget and without perturbations:
/// - `effects`: main effects and interactions on the share solved, the cost (log10 of the
///   evaluations to solve, or spent) and the accuracy (share of targets reached), of each family's
///   five best entries by share solved; the machine is the unit of the intervals;
/// - `main_effects`: all their main effects on the share solved, significant or not;
/// - `turns`: the entry that solves most at each level of each factor.
report::Json factor_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         const std::vector<ReportedPart>& parts);

using namespace ricochet::comparison;

/// Effects of perturbations on solvers, by family, with the largest budget. Each solver is in the
/// formulation that does best over all perturbations together; "plain" uses the same cells as the
/// perturbation:
/// - `perturbations`: a row for each perturbation: means over solvers with and without it, the
///   number of solvers that it harms significantly, the most harmed ones, and the one that solves
///   most under it;
/// - `perturbation_rows`: a row for each solver, with a success rate for each perturbation, the
///   problems and runs under each, and the variables of the problems;
/// - `atlas`: for every machine and perturbation the outcomes of the runs, and a command that
///   repeats one of the failed ones.
/// Lists are empty if the campaign has no perturbation but "plain".
report::Json perturbation_data(const Campaign& campaign, const std::vector<CellResult>& results);

/// How the user's solvers did beside the others: `own_solvers`, a row for each of them and each
/// family with its largest budget, with the success rate of its entry, its interval, the number of
/// other solvers that solve fewer and more of the problems that both take (if these are at least
/// half of the family's), and on how many of these the difference is significant: Wilcoxon's
/// signed-rank test over problems, with Holm's correction over the solvers of the family, at 5 %.
/// `own_totals`, a row for each: the problems that it solved in most of its runs.
report::Json own_solver_data(const Campaign& campaign, const std::vector<EntrySet>& sets,
                             const std::vector<Solver>& suite);

/// Does the order hold on problems held out? For every group, with the largest budget: how well the
/// order of the ranked entries on half of the problems predicts that on the other half. `measured`
/// is false for a group with too few problems or entries.
report::Json held_out_data(const Comparison& comparison, const std::vector<Group>& groups);

/// Bias of entries towards the ends or the middle of the box: the share of runs that each solves of
/// the relocated-optimum variants with the best point at the lower end, in the middle and at the
/// upper end, for every part of the plan that relocates the optimum: in `relocated_optima` a row
/// for each entry, in `relocated` the number of problems and of variables.
report::Json relocated_optimum_data(const Campaign& campaign,
                                    const std::vector<CellResult>& results);

/// For every family that is posed on a grid of machines, maps over their factors, all of one shape:
/// in `machines` the best known values, in `machine_maps` the share solved by each of its best
/// entries. The first factor has a column for each level, the others a row for each combination.
/// `landscapes` has the true objective of problems of one variable without constraints, e.g. the
/// collisions over the speed, a row for each machine.
report::Json machine_data(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<ReportedPart>& parts);

/// The result of an entry on one problem, mean over its runs.
struct MachineResult {
  const Problem* problem;
  double solved = 0;    ///< share
  double cost = 0;      ///< log10 of the evaluations until solved, or of all
  double accuracy = 0;  ///< share of the problem's targets reached
};

/// The results of entries, by solver and formulation, on the problems of a family.
using ByEntry = std::map<std::pair<std::string, std::string>, std::vector<MachineResult>>;

/// Returns, by family, the results of each entry on those problems of a part that vary the machine.
std::map<std::string, ByEntry> machine_results(const Campaign& campaign,
                                               const std::vector<CellResult>& results,
                                               const ReportedPart& part);

/// Returns the factors of a family's machines that have several levels, with their levels. It is
/// empty if there are no more machines than such factors: their effects could not be separated.
std::map<std::string, std::vector<double>> factors_of(const ByEntry& entries);

double mean_solved(const std::vector<MachineResult>& results);

/// The entries of a family, most solved first.
std::vector<const ByEntry::value_type*> best_first(const ByEntry& entries);

std::string name_of(const ByEntry::value_type& entry);

/// Returns the name of a factor's level: a number, or the name of a fidelity.
std::string level_name(const std::string& factor, double level);

}  // namespace ricochet::studies::comparison
