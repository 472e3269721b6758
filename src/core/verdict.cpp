#include "src/core/verdict.h"

namespace ricochet {

Truth truth_at(const Problem& problem, const Vector& x) {
  return problem.truth ? problem.truth(x) : truth_of(problem.evaluate(x), problem.equalities);
}

Verdict judge(const RunRecord& record, const Problem& problem, double tolerance) {
  Verdict verdict;
  for (const Improvement& step : record.trace) {
    if (step.truth.violation > 0) continue;
    verdict.feasible = true;
    verdict.objective = step.truth.objective;
    if (!problem.best_known) continue;
    verdict.regret = step.truth.objective - *problem.best_known;
    if (*verdict.regret <= tolerance && !verdict.solved) {
      verdict.solved = true;
      verdict.evaluations_to_solve = step.evaluations;
      verdict.seconds_to_solve = step.seconds;
    }
  }
  return verdict;
}

}  // namespace ricochet
