#pragma once

#include <cstddef>
#include <vector>

#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet {

/// The best value so far is `value` from the evaluation `evaluations` >= 1 on.
struct BestSoFar {
  double evaluations, value;
};

/// The improvements of a run: evaluations rise, values fall. Empty if the run found nothing.
using History = std::vector<BestSoFar>;

/// Throws std::invalid_argument for a history that breaks these rules.
void check_history(const History& history);

/// The best and the worst value that count, lower < upper. Fixed before the runs, not taken from
/// them.
struct Levels {
  double lower, upper;
};

/// Attainment of a run at its evaluation t: (upper - b) / (upper - lower), where b is the best
/// value so far, clamped to [lower, upper]; 0 before the first improvement. For integer values it
/// is the share of the levels lower, lower + 1, ..., upper - 1 that b has reached, so that no
/// targets need be chosen (Grunert da Fonseca, Fonseca and Hall 2001, doi:10.1007/3-540-44719-9_15;
/// López-Ibáñez et al. 2024, doi:10.1109/TEVC.2024.3462758). Throws std::invalid_argument for
/// invalid levels or an invalid history.
double attainment(const History& history, const Levels& levels, double t);

enum class EvaluationAxis { linear, logarithmic };

/// Area over the convergence curve, in [0, 1]: the mean of the attainment over the evaluations 1 to
/// `budget` >= 1. On a linear axis each evaluation has the same weight; on a logarithmic axis
/// evaluation i has the weight log((i + 1) / i). Throws std::invalid_argument as above, or for a
/// smaller budget.
double area_over_convergence_curve(const History& history, const Levels& levels, double budget,
                                   EvaluationAxis axis);

/// The runs of a solver, by unit: runs of one unit are alike, units are independent. The units are
/// problems or machines; if there is only one problem, its runs.
using RunsOfUnits = std::vector<std::vector<History>>;

/// The grid of an attainment function: numbers of evaluations and values.
struct AttainmentGrid {
  std::vector<double> evaluations, values;
};

struct Attained {
  double share;
  Interval interval;
};

/// Empirical attainment function on a grid: alpha(t, z) is the share of runs whose best value after
/// t evaluations is z or less, every unit having the same weight (Grunert da Fonseca, Fonseca and
/// Hall 2001, doi:10.1007/3-540-44719-9_15; López-Ibáñez et al. 2024,
/// doi:10.1109/TEVC.2024.3462758), with the pointwise interval of mean_share() over units. Entry
/// [i][k] is for the i-th number of evaluations and the k-th value. Throws std::invalid_argument
/// for no units, a unit without runs, or an invalid history.
std::vector<std::vector<Attained>> attainment_function(const RunsOfUnits& runs,
                                                       const AttainmentGrid& grid,
                                                       double confidence = 0.95);

/// alpha_A - alpha_B on the grid, in [-1, 1]: positive where A leads (López-Ibáñez, Paquete and
/// Stützle 2010, doi:10.1007/978-3-642-02538-9_9). Both have the same units in the same order, and
/// the interval is that of the mean of the differences within units. Throws std::invalid_argument
/// as above, or for different numbers of units.
std::vector<std::vector<Attained>> attainment_difference(const RunsOfUnits& a, const RunsOfUnits& b,
                                                         const AttainmentGrid& grid,
                                                         double confidence = 0.95);

/// ECDF of runtimes (data profile): the share of the pairs of a problem and a target that are
/// reached within the time t, in evaluations or seconds (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977; Moré and Wild 2009, doi:10.1137/080724083). `hitting_times`
/// has an entry for each problem: the times to its targets in all runs, infinite if never reached.
/// Every problem has the same weight, and the pointwise interval is over problems, because the
/// targets and runs of one problem are alike. Throws std::invalid_argument if a problem has no
/// times, or a time is no number.
MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 double confidence = 0.95);

/// Performance ratios: each cost over the least cost of any solver for the problem, >= 1. Infinite
/// if the solver failed, even if all others failed too (Dolan and Moré 2002,
/// doi:10.1007/s101070100263, equation 2.1). They depend on the solvers present: a third solver may
/// change which of two is ahead (Gould and Scott 2016, doi:10.1145/2950048), so compare two by the
/// ratios of costs_of_pair(). Throws std::invalid_argument for invalid costs.
Costs performance_ratios(const Costs& costs);

/// Extended performance ratios: each cost over the least cost of the other solvers, so that the
/// ratio of a winner is below 1 and shows its margin (Bussieck, Dirkse and Vigerske 2014, PAVER
/// 2.0, doi:10.1007/s10898-013-0131-5). 0 if it is the only one to solve the problem, infinite if
/// it failed. Throws std::invalid_argument as above, or for a single solver.
Costs extended_performance_ratios(const Costs& costs);

/// Performance profile at `ratio`: the share of problems on which this solver's ratio is finite and
/// at most `ratio`, with its pointwise interval over problems. At 1 it is the share of wins,
/// including ties; at infinity the share of problems solved. Throws std::invalid_argument for
/// ratios that are negative or rows of different lengths, or an index without a solver.
MeanShare performance_profile(const Costs& ratios, std::size_t solver, double ratio,
                              double confidence = 0.95);

enum class SolvedBy { both, only_a, only_b, neither };

/// log2(cost of A / cost of B) on one problem: negative where A is cheaper.
struct LogRatio {
  std::size_t problem;
  double log2_ratio;
  SolvedBy solved_by;
};

/// The log-ratios of two solvers on all problems, in rising order (Morales 2002,
/// doi:10.1016/S0893-9659(01)00162-8, with the conventions of OptiProfiler,
/// https://www.optprof.com). If one solver failed, the bar is 1.1 times the largest ratio in favour
/// of the other; if both failed, there are two bars, the first and the last of all, one on each
/// side. If every ratio is 0, or there is none, 1 replaces the largest. A cost is > 0, and infinite
/// for a failure. Throws std::invalid_argument for other costs, or samples that are empty or differ
/// in length.
std::vector<LogRatio> log_ratio_profile(const std::vector<double>& costs_of_a,
                                        const std::vector<double>& costs_of_b);

}  // namespace ricochet
