#include "ricochet/verdict.h"

namespace ricochet {

Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance) {
  Verdict verdict;
  for (const Improvement& step : record.trace) {
    if (step.true_values.violation > 0) continue;
    verdict.feasible = true;
    verdict.objective = step.true_values.objective;
    if (!best_known) continue;
    verdict.optimality_gap = step.true_values.objective - *best_known;
    if (*verdict.optimality_gap <= tolerance && !verdict.solved) {
      verdict.solved = true;
      verdict.evaluations_to_solve = step.evaluations;
      verdict.seconds_to_solve = step.seconds;
    }
  }
  const auto& returned = record.returned;
  if (returned && returned->true_values.violation <= 0 && best_known) {
    verdict.returned_optimality_gap = returned->true_values.objective - *best_known;
    verdict.returned_solved = *verdict.returned_optimality_gap <= tolerance;
  }
  return verdict;
}

Verdict judge(const RunRecord& record, const Problem& problem, double tolerance) {
  return judge(record, problem.best_known, tolerance);
}

}  // namespace ricochet
