#include "src/core/verdict.h"

namespace ricochet {

Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance) {
  Verdict verdict;
  for (const Improvement& step : record.trace) {
    if (step.truth.violation > 0) continue;
    verdict.feasible = true;
    verdict.objective = step.truth.objective;
    if (!best_known) continue;
    verdict.regret = step.truth.objective - *best_known;
    if (*verdict.regret <= tolerance && !verdict.solved) {
      verdict.solved = true;
      verdict.evaluations_to_solve = step.evaluations;
      verdict.seconds_to_solve = step.seconds;
    }
  }
  const auto& handed_over = record.handed_over;
  if (handed_over && handed_over->truth.violation <= 0 && best_known) {
    verdict.handed_over_regret = handed_over->truth.objective - *best_known;
    verdict.handed_over_solved = *verdict.handed_over_regret <= tolerance;
  }
  return verdict;
}

Verdict judge(const RunRecord& record, const Problem& problem, double tolerance) {
  return judge(record, problem.best_known, tolerance);
}

}  // namespace ricochet
