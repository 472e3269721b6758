#include "src/analysis/outcomes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"
#include "src/core/names.h"

namespace ricochet::comparison {

Reason::Reason(const std::string& text) {
  static std::mutex mutex;
  static std::unordered_set<std::string> texts;
  const std::lock_guard lock(mutex);
  text_ = &*texts.insert(text).first;
}

double Outcome::optimality_gap() const {
  return verdict.returned_optimality_gap.value_or(std::numeric_limits<double>::infinity());
}

double merit_gap(const Problem& problem, const Outcome& outcome) {
  if (!outcome.returned) return std::numeric_limits<double>::infinity();
  const auto& [objective, violation] = *outcome.returned;
  const double gap = std::max(0.0, objective - problem.best_known.value());
  const double merit = violation > 0 ? gap + problem.penalty_weight * violation : gap;
  return std::isnan(merit) || std::isnan(violation) || std::isnan(objective)
             ? std::numeric_limits<double>::infinity()
             : merit;
}

std::vector<Step> steps_of(const Outcome& outcome) {
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

double seconds_until_solved(const Outcome& outcome) {
  if (!outcome.solved()) return outcome.seconds;
  return outcome.verdict.seconds_to_solve.value_or(outcome.seconds);
}

Outcome outcome_of(const RunRecord& record, double best_known, double tolerance) {
  Outcome outcome;
  outcome.instance = record.instance;
  outcome.verdict = judge(record, best_known, tolerance);
  if (record.returned) outcome.returned = record.returned->true_values;
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

void each_judged(const Store& store, const std::function<void(const JudgedRun&)>& use,
                 const std::function<void(const JudgedCell&)>& at_end) {
  std::map<std::string, const StoredProblem*> problems;
  for (const StoredProblem& problem : store.description().problems) {
    problems[problem.name] = &problem;
  }
  std::optional<Cell> cell;
  std::vector<Outcome> outcomes;
  const auto end_cell = [&] {
    outcomes.shrink_to_fit();  // a report keeps a million outcomes
    if (cell) at_end({*cell, *problems.at(cell->problem), std::move(outcomes)});
    outcomes.clear();
  };
  store.each([&](const StoredRun& run) {
    if (cell != run.key.cell) {
      end_cell();
      cell = run.key.cell;
    }
    const StoredProblem& problem = *problems.at(cell->problem);
    outcomes.push_back(outcome_of(run.record, problem.best_known, problem.tolerance));
    use({problem, run, outcomes.back()});
  });
  end_cell();
}

Reached reached_by(const Outcome& outcome) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Step> steps = steps_of(outcome);
  if (steps.empty()) return {infinity, infinity};
  if (outcome.solved()) {
    return {0, static_cast<double>(evaluations_until_solved(outcome))};
  }
  return {steps.back().optimality_gap, static_cast<double>(steps.back().evaluations)};
}

std::vector<Problem> chosen_problems(const std::vector<Problem>& all, const std::string& patterns,
                                     const std::string& option) {
  std::vector<Problem> chosen;
  std::vector<std::string> names;
  const std::vector<std::string> list = split_patterns(patterns);
  for (const Problem& problem : all) {
    if (!problem.best_known) continue;
    names.push_back(problem.name);
    if (is_chosen(problem, list)) chosen.push_back(problem);
  }
  require_fit(list, names, option, "`ricochet list problems`");
  return chosen;
}

std::vector<Solver> chosen_solvers(const std::vector<Solver>& all, const std::string& patterns,
                                   const std::string& option) {
  std::vector<Solver> chosen;
  std::vector<std::string> names;
  const std::vector<std::string> list = split_patterns(patterns);
  for (const Solver& solver : all) {
    names.push_back(solver.name);
    if (fits_any(solver.name, list)) chosen.push_back(solver);
  }
  require_fit(list, names, option, "`ricochet list solvers`");
  return chosen;
}

namespace {

constexpr int points = 15;
constexpr int precisions = 51;

std::optional<TrueValues> values_at(const Problem& problem, const Vector& x) {
  try {
    const TrueValues values = true_values_at(problem, x);
    const bool finite = std::isfinite(values.objective) && !std::isnan(values.violation);
    return finite ? std::optional(values) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // no solver gets a value there either
  }
}

}  // namespace

double reference_gap(const Problem& problem) {
  Random random(seed_of(problem.name, "targets", 0, 0));
  std::vector<double> feasible;
  std::vector<double> sizes;
  for (int k = 0; k < points; ++k) {
    const auto values = values_at(problem, uniform_point(problem, random));
    if (!values) continue;
    const double gap = values->objective - problem.best_known.value();
    if (values->violation <= 0) feasible.push_back(gap);
    sizes.push_back(std::abs(gap));
  }
  if (sizes.empty()) return 0;
  return quantile(feasible.empty() ? sizes : feasible, 0.5);
}

Targets targets_of(const Problem& problem) {
  const double tolerance = problem.tolerance;
  const double reference = reference_gap(problem);
  Targets targets{tolerance};
  if (tolerance == 0.5) {
    while (targets.back() + 1 < reference) targets.push_back(targets.back() + 1);
    return targets;
  }
  // A tolerance of 0 has no logarithm: the precision of a double below the reference.
  const double least = std::max(tolerance, 1e-16 * reference);
  if (!(reference > least)) return targets;
  for (int k = 1; k < precisions; ++k) {
    targets.push_back(least * std::pow(reference / least, k / (precisions - 1.0)));
  }
  return targets;
}

}  // namespace ricochet::comparison
