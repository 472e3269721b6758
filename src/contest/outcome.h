#pragma once

#include <string>
#include <vector>

#include "src/core/verdict.h"

namespace ricochet::contest {

/// When a run found something feasible and better than all before it.
struct Step {
  std::int64_t evaluations;  ///< charged until then
  double seconds;
  double regret;  ///< true objective less the best known
};

/// One run as it is judged; what it takes to run it again is its number among the instances.
struct Outcome {
  int instance = 0;
  Verdict verdict;
  std::int64_t evaluations = 0;  ///< charged in all
  double seconds = 0;            ///< processor time in all
  std::vector<Step> steps;
  std::vector<std::string> exits;  ///< what the solver said at the end of every start
  std::string failure;             ///< what was thrown; empty if nothing
};

/// Judges a record. The problem's best value must be known.
Outcome outcome_of(const RunRecord& record, double best_known, double tolerance);
Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet::contest
