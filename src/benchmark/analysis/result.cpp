#include "src/benchmark/analysis/result.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/expected_running_time.h"
#include "src/benchmark/statistics/order_statistic_interval.h"
#include "src/benchmark/statistics/wilson_interval.h"

namespace ricochet::comparison {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same(const Outcome& a, const Outcome& b) {
  return a.evaluations == b.evaluations && a.optimality_gap() == b.optimality_gap() &&
         std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                    [](const Step& p, const Step& q) {
                      return p.evaluations == q.evaluations && p.optimality_gap == q.optimality_gap;
                    });
}

/// One of each group of equal outcomes.
std::vector<const Outcome*> distinct(const Outcomes& outcomes) {
  const std::vector<bool> repeated = repeats(outcomes);
  std::vector<const Outcome*> kept;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (!repeated[k]) kept.push_back(&outcomes[k]);
  }
  return kept;
}

template <class Solved>
SolvedShare share_of(const std::vector<const Outcome*>& outcomes, Solved solved) {
  const auto trials = static_cast<double>(outcomes.size());
  const auto successes =
      static_cast<double>(std::count_if(outcomes.begin(), outcomes.end(), solved));
  return {successes / trials, wilson_interval(successes, trials)};
}

std::optional<Estimate> running_time_of(const std::vector<const Outcome*>& outcomes,
                                        Criterion criterion) {
  std::vector<Effort> evaluations;
  for (const Outcome* o : outcomes) {
    evaluations.push_back(
        {static_cast<double>(evaluations_until_solved(*o, criterion)), o->solved(criterion)});
  }
  const auto time = expected_running_time(evaluations);
  if (!time) return std::nullopt;
  return Estimate{*time, expected_running_time_interval(evaluations)};
}

}  // namespace

std::vector<bool> repeats(const Outcomes& outcomes) {
  std::vector<bool> repeated;
  std::vector<const Outcome*> kept;
  for (const Outcome& outcome : outcomes) {
    const bool seen = std::any_of(kept.begin(), kept.end(),
                                  [&](const Outcome* other) { return same(*other, outcome); });
    if (!seen) kept.push_back(&outcome);
    repeated.push_back(seen);
  }
  return repeated;
}

Result result_of(const Outcomes& outcomes) {
  Result result;
  result.runs = static_cast<int>(outcomes.size());
  const std::vector<const Outcome*> once = distinct(outcomes);
  result.distinct = static_cast<int>(once.size());
  result.found = share_of(once, [](const Outcome* o) { return o->solved(Criterion::evaluated); });
  result.returned = share_of(once, [](const Outcome* o) { return o->solved(); });
  result.running_time = running_time_of(once, Criterion::evaluated);
  result.returned_running_time = running_time_of(once, Criterion::returned);
  std::vector<Effort> seconds;
  std::vector<double> gaps;
  for (const Outcome* o : once) {
    seconds.push_back({seconds_until_solved(*o), o->solved()});
    gaps.push_back(o->optimality_gap());
  }
  result.seconds_to_solve = expected_running_time(seconds);
  result.gap.value = quantile(gaps, 0.5);
  result.gap.interval = order_statistic_interval(gaps).value_or(Interval{-infinity, infinity});
  for (const Outcome& outcome : outcomes) {
    result.failed += outcome.failure.empty() ? 0 : 1;
    for (const std::string& exit : outcome.terminations) ++result.terminations[exit];
  }
  return result;
}

}  // namespace ricochet::comparison
