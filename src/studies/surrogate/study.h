#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/report/json.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// Can the surrogate and its gradient be trusted? Takes some minutes on two processors.
Study surrogate_study();

}  // namespace ricochet::studies

/// Surrogate bias: how far the surrogate's optima are from those of the count, at every smoothing
/// parameter.
namespace ricochet::studies::surrogate {

struct BiasPlan {
  double step;                     ///< [rad/s] between the speeds, up to 18 rad/s
  std::vector<double> smoothings;  ///< from wide to narrow
};

/// One case at one smoothing parameter.
struct Bias {
  double smoothing;
  double error;                            ///< mean |surrogate - count| over the speeds
  std::optional<double> rank_correlation;  ///< Spearman's; nothing if one of them is constant
  double count_optimality_gap;  ///< count at the surrogate's minimum, minus the lowest count
  /// The fastest speed at which the surrogate is quiet, and the fastest at which the count is minus
  /// this speed [rad/s], below 0 if the surrogate's is faster. Nothing if the surrogate is never
  /// quiet.
  std::optional<double> speed, speed_optimality_gap;
  bool loud = false;  ///< whether the count is loud at that speed
};

struct CaseBias {
  std::string id;
  int lowest;      ///< count
  double fastest;  ///< [rad/s] at which the count is quiet
  std::vector<Bias> biases;
};

struct BiasStudy {
  BiasPlan plan;
  std::vector<CaseBias> cases;
};

/// Every case of the paper in the default interpretation.
BiasStudy study_bias(const BiasPlan& plan);

report::Json data_of(const BiasStudy& study);

// Do solvers with continuation from a large smoothing parameter to zero find the optimum of the
// count?

struct ContinuationPlan {
  int instances;
  std::vector<long> budgets;  ///< evaluations per run
};

/// The runs of one solver, with one budget, on the fastest quiet speed of one case.
struct ContinuationRuns {
  std::string id;
  std::string solver;
  long budget;
  int solved;                   ///< runs within the tolerance of the best, scored on the true count
  double worst_optimality_gap;  ///< [rad/s]; infinite if a run evaluated no quiet speed
  std::string exit;             ///< last termination reason in the first run that did not solve it
};

struct ContinuationStudy {
  ContinuationPlan plan;
  std::vector<ContinuationRuns> rows;  ///< by case, solver and budget
};

/// Optimality gap [rad/s] that still counts as solved.
inline constexpr double speed_tolerance = 0.01;

/// Summarises runs of one solver, at least one, on instances of a problem.
ContinuationRuns runs_of(const std::string& id, const Problem& problem,
                         const std::vector<RunRecord>& records);

/// C1..C10, for which the paper claims a threshold.
ContinuationStudy study_continuation(const ContinuationPlan& plan);

report::Json data_of(const ContinuationStudy& study);

}  // namespace ricochet::studies::surrogate
