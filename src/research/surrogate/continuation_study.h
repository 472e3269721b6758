#pragma once

#include <string>
#include <vector>

#include "src/core/run.h"
#include "src/report/json.h"

/// Whether solvers led from a wide smoothing width to zero find what the count says.
namespace ricochet::studies::surrogate {

struct ContinuationPlan {
  int instances;
  std::vector<long> budgets;  ///< evaluations of a run
};

/// The runs of one solver, with one budget, on the fastest quiet speed of one case.
struct ContinuationRuns {
  std::string id;
  std::string solver;
  long budget;
  int solved;           ///< runs within the tolerance of the best, judged by the true count
  double worst_regret;  ///< [rad/s]; infinite where a run found no quiet speed
  std::string exit;     ///< what the solver said last, in the first run that did not solve it
};

struct ContinuationStudy {
  ContinuationPlan plan;
  std::vector<ContinuationRuns> rows;  ///< by case, solver and budget
};

/// Regret [rad/s] that still counts as solved.
inline constexpr double speed_tolerance = 0.01;

/// Sums up runs of one solver, one at least, on instances of a problem.
ContinuationRuns runs_of(const std::string& id, const Problem& problem,
                         const std::vector<RunRecord>& records);

/// C1..C10, for which the paper claims a threshold.
ContinuationStudy study_continuation(const ContinuationPlan& plan);

report::Json data_of(const ContinuationStudy& study);

}  // namespace ricochet::studies::surrogate
