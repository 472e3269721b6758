#include "src/studies/reproduction/comparison.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "src/campaign/runner.h"
#include "src/core/instance.h"
#include "src/core/verdict.h"
#include "src/statistics/bootstrap.h"

namespace ricochet::studies::reproduction {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Best feasible true objective reached at no more than `price`; infinite if none.
template <class PriceOf>
double reached(const RunRecord& record, double price, PriceOf price_of) {
  double best = infinity;
  for (const Improvement& step : record.trace) {
    if (price_of(step) > price) break;
    if (step.truth.violation <= 0) best = step.truth.objective;
  }
  return best;
}

template <class PriceOf>
Progression progression(const std::vector<RunRecord>& records, double least, double most,
                        PriceOf price_of) {
  constexpr int points = 40;
  constexpr int resamples = 200;
  Progression result;
  result.solver = records.front().solver;
  for (int i = 0; i < points; ++i) {
    const double price = least * std::pow(most / least, i / (points - 1.0));
    std::vector<double> values;
    for (const RunRecord& r : records) values.push_back(reached(r, price, price_of));
    const double median = quantile(values, 0.5);
    if (std::isinf(median)) continue;
    const Interval interval = median_interval(values, 0.95, resamples, records.front().seed);
    result.price.push_back(price);
    result.median.push_back(median);
    result.lower.push_back(interval.lower);
    result.upper.push_back(interval.upper);
  }
  return result;
}

Standing standing(const std::vector<RunRecord>& records, const Question& question,
                  const Form& form) {
  Standing result;
  result.solver = records.front().solver;
  result.form = question.name_of(form);
  for (const RunRecord& record : records) {
    const Verdict verdict = judge(record, question.stated, question.tolerance);
    result.failed += record.failure.empty() ? 0 : 1;
    result.regrets.push_back(verdict.regret.value_or(infinity));
    const auto spent =
        static_cast<double>(verdict.evaluations_to_solve.value_or(record.ledger.charged));
    result.evaluations.push_back({spent, verdict.solved});
    result.seconds.push_back(
        {verdict.seconds_to_solve.value_or(record.ledger.seconds), verdict.solved});
  }
  return result;
}

/// The runs of one solver on one question.
struct Entry {
  std::size_t question;
  const Solver* solver;
  Form form;
};

/// Each solver with the first form of each question that it accepts.
std::vector<Entry> entries_of(const std::vector<Question>& questions,
                              const std::vector<Solver>& solvers) {
  std::vector<Entry> entries;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    for (const Solver& solver : solvers) {
      for (const Form& form : questions[q].forms()) {
        if (!solver.accepts(questions[q].problem(form))) continue;
        entries.push_back({q, &solver, form});
        break;
      }
    }
  }
  return entries;
}

}  // namespace

std::vector<ContestResult> compare(const std::vector<Question>& questions,
                                   const std::vector<Solver>& solvers, const ComparisonPlan& plan) {
  const auto entries = entries_of(questions, solvers);
  std::deque<Problem> problems;  // stays in place while the jobs point into it
  std::vector<Job> jobs;
  for (const Entry& entry : entries) {
    const Problem shown = questions[entry.question].problem(entry.form);
    for (int i = 1; i <= plan.instances; ++i) {
      problems.push_back(instance(shown, i));
      jobs.push_back({&problems.back(), entry.solver, plan.budget, 0});
    }
  }
  Progress progress("comparing solvers", static_cast<double>(jobs.size()));
  const auto records = run_all(jobs, progress);

  std::vector<ContestResult> results;
  for (const Question& question : questions) results.push_back({question, {}, {}, {}});
  const auto most = static_cast<double>(plan.budget.evaluations);
  double slowest = 1e-5;
  for (const RunRecord& r : records) slowest = std::max(slowest, r.ledger.seconds);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const auto first = records.begin() + static_cast<std::ptrdiff_t>(e) * plan.instances;
    const std::vector<RunRecord> mine(first, first + plan.instances);
    ContestResult& result = results[entries[e].question];
    result.standings.push_back(standing(mine, result.question, entries[e].form));
    result.by_evaluations.push_back(progression(mine, 1, most, [](const Improvement& step) {
      return static_cast<double>(step.evaluations);
    }));
    result.by_seconds.push_back(
        progression(mine, 1e-5, slowest, [](const Improvement& step) { return step.seconds; }));
  }
  return results;
}

}  // namespace ricochet::studies::reproduction
