#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/intervals.h"
#include "src/experiment/campaign.h"

namespace ricochet::comparison {

/// A share of runs with Wilson's interval, both in [0, 1].
struct SolvedShare {
  double share;
  Interval interval;
};

/// An estimate with its interval; an end is infinite if too few runs reached the target.
struct Estimate {
  double value;
  Interval interval;
};

/// A summary of the runs of one cell. Intervals are of 95 %.
struct Result {
  int runs = 0;
  int distinct = 0;                 ///< number of different runs: repeats are counted once
  SolvedShare found{}, returned{};  ///< solved by an evaluated point, by the returned point
  /// ERT [evaluations] of the problem's tolerance, by the best evaluated and by the returned point;
  /// nothing if no run solved it.
  std::optional<Estimate> running_time, returned_running_time;
  std::optional<double> seconds_to_solve;  ///< expected processor time, by the returned point
  double gap = 0;  ///< median optimality gap of the returned points; infinite: none is feasible
  int failed = 0;  ///< runs that ended in an exception
};

/// For each run of a cell, whether it repeats an earlier one: as many evaluations, the same
/// improvements at the same evaluations, and a returned point of the same value. Then the solver
/// draws no random numbers, or the instances look alike to it.
std::vector<bool> repeats(const Outcomes& outcomes);

/// The summary of `outcomes` of one cell; there must be at least one.
Result result_of(const Outcomes& outcomes);

/// The outcomes of the runs of one cell, sorted by instance, then run: one solver-formulation pair
/// on one problem with one budget.
struct CellResult {
  const PlannedCell* cell;
  Outcomes outcomes;
  std::shared_ptr<const Targets> targets;  ///< of the problem
};

/// The results of every cell of a campaign, which must outlive them. Each run of the store is read
/// once and also passed to `also`, as in Store::each. Throws InputError if the store lacks runs.
std::vector<CellResult> cell_results(
    const Campaign& campaign, const Store& store,
    const std::function<void(const StoredRun&)>& also = [](const StoredRun&) {});

/// The largest budget of any cell, by problem (an index of the campaign's).
std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<CellResult>& results);

/// The conditions shared by all results of a comparison.
struct Conditions {
  std::size_t part = 0;  ///< of the plan
  std::string perturbation = "plain";
  std::string gradient_price = "n";
  int run = 0;
};

/// The cluster of a problem, whose problems are alike; see Problem::cluster.
const std::string& cluster_of(const Problem& problem);

/// Results of one part of a campaign under the same conditions: their cells differ only in problem,
/// formulation, solver and budget, and each has one outcome for each instance.
struct Comparison {
  const Campaign* campaign;
  const PlanPart* part;
  int run;  ///< number of the runs
  std::vector<CellResult> results;

  const Problem& problem_of(const CellResult& result) const {
    return campaign->problems()[result.cell->problem];
  }

  bool has_largest_budget(const CellResult& result) const {
    return result.cell->cell.budget == part->budgets.back();
  }

  /// Indices into the campaign's problems, in order of first occurrence.
  std::vector<std::size_t> problems() const;
};

/// The campaign must outlive the result.
Comparison comparison_of(const Campaign& campaign, const std::vector<CellResult>& results,
                         const Conditions& conditions);

/// Surrogate bias: the optimum of a surrogate, scored on the true objective. No solver that follows
/// the surrogate to its optimum does better.
struct Ceiling {
  double optimum;                        ///< the surrogate's, in the problem's variable
  double distance;                       ///< from the optimum to the best known point
  std::optional<double> optimality_gap;  ///< nothing if the optimum is truly infeasible
};

/// Found by a scan with ten times the problem's scan step, then Brent's method around the best
/// point. Nothing for a problem of several variables, or without a surrogate or a best point.
std::optional<Ceiling> ceiling(const Problem& problem, double smoothing);

}  // namespace ricochet::comparison
