#include "src/contest/outcome.h"

namespace ricochet::contest {

Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance) {
  Outcome outcome;
  outcome.instance = record.instance;
  outcome.verdict = judge(record, problem, tolerance);
  outcome.evaluations = record.ledger.charged;
  outcome.seconds = record.ledger.seconds;
  outcome.failure = record.failure;
  for (const Improvement& step : record.trace) {
    if (step.truth.violation > 0) continue;
    outcome.steps.push_back(
        {step.evaluations, step.seconds, step.truth.objective - problem.best_known.value()});
  }
  for (const SolverExit& exit : record.exits) outcome.exits.push_back(exit.reason);
  return outcome;
}

}  // namespace ricochet::contest
