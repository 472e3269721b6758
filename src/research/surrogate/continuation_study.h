#pragma once

#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/report/json.h"

/// Do solvers with continuation from a large smoothing parameter to zero find the optimum of the
/// count?
namespace ricochet::studies::surrogate {

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
