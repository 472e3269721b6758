#include "src/benchmark/analysis/outcome.h"

#include <mutex>
#include <unordered_set>

namespace ricochet::comparison {

Reason::Reason(const std::string& text) {
  static std::mutex mutex;
  static std::unordered_set<std::string> texts;
  const std::lock_guard lock(mutex);
  text_ = &*texts.insert(text).first;
}

Outcome outcome_of(const RunRecord& record, double best_known, double tolerance) {
  Outcome outcome;
  outcome.instance = record.instance;
  outcome.verdict = judge(record, best_known, tolerance);
  outcome.evaluations = record.ledger.charged;
  outcome.values = record.ledger.values;
  outcome.derivatives = record.ledger.derivatives;
  outcome.seconds = record.ledger.seconds;
  outcome.failure = record.failure;
  // Exact capacity to save memory: a report keeps the steps of a million runs.
  outcome.steps.reserve(record.trace.size());
  outcome.terminations.reserve(record.terminations.size());
  for (const Improvement& step : record.trace) {
    if (step.true_values.violation > 0) continue;
    outcome.steps.push_back(
        {step.evaluations, step.seconds, step.true_values.objective - best_known});
  }
  for (const SolverTermination& exit : record.terminations)
    outcome.terminations.emplace_back(exit.reason);
  return outcome;
}

Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance) {
  return outcome_of(record, problem.best_known.value(), tolerance);
}

}  // namespace ricochet::comparison
