#include "src/contest/outcome.h"

#include <mutex>
#include <unordered_set>

namespace ricochet::contest {

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
  // No more memory than they need: a report keeps those of a million runs.
  outcome.steps.reserve(record.trace.size());
  outcome.exits.reserve(record.exits.size());
  for (const Improvement& step : record.trace) {
    if (step.truth.violation > 0) continue;
    outcome.steps.push_back({step.evaluations, step.seconds, step.truth.objective - best_known});
  }
  for (const SolverExit& exit : record.exits) outcome.exits.emplace_back(exit.reason);
  return outcome;
}

Outcome outcome_of(const RunRecord& record, const Problem& problem, double tolerance) {
  return outcome_of(record, problem.best_known.value(), tolerance);
}

}  // namespace ricochet::contest
