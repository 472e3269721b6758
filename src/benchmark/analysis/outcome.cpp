#include "src/benchmark/analysis/outcome.h"

#include <limits>
#include <mutex>
#include <unordered_set>

namespace ricochet::comparison {

Reason::Reason(const std::string& text) {
  static std::mutex mutex;
  static std::unordered_set<std::string> texts;
  const std::lock_guard lock(mutex);
  text_ = &*texts.insert(text).first;
}

double Outcome::optimality_gap(Criterion criterion) const {
  const auto& gap =
      criterion == Criterion::returned ? verdict.returned_optimality_gap : verdict.optimality_gap;
  return gap.value_or(std::numeric_limits<double>::infinity());
}

std::vector<Step> steps_of(const Outcome& outcome, Criterion criterion) {
  if (criterion == Criterion::evaluated) return outcome.steps;
  const auto& gap = outcome.verdict.returned_optimality_gap;
  if (!gap) return {};
  std::vector<Step> steps;
  for (const Step& step : outcome.steps) {
    steps.push_back(step);
    if (step.optimality_gap <= *gap) {
      steps.back().optimality_gap = *gap;
      return steps;
    }
  }
  steps.push_back({outcome.evaluations, outcome.seconds, *gap});
  return steps;
}

std::int64_t evaluations_until_solved(const Outcome& outcome, Criterion criterion) {
  if (!outcome.solved(criterion)) return outcome.evaluations;
  return outcome.verdict.evaluations_to_solve.value_or(outcome.evaluations);
}

double seconds_until_solved(const Outcome& outcome, Criterion criterion) {
  if (!outcome.solved(criterion)) return outcome.seconds;
  return outcome.verdict.seconds_to_solve.value_or(outcome.seconds);
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
