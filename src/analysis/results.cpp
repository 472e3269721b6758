#include "src/analysis/results.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "ricochet/error.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet::comparison {

namespace {

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
  result.gap = quantile(gaps, 0.5);
  for (const Outcome& outcome : outcomes) result.failed += outcome.failure.empty() ? 0 : 1;
  return result;
}

std::vector<CellResult> cell_results(const Campaign& campaign, const Store& store,
                                     const std::function<void(const StoredRun&)>& also) {
  const std::vector<Problem>& problems = campaign.problems();
  std::vector<std::shared_ptr<const Targets>> targets(problems.size());
  tbb::parallel_for(std::size_t{0}, problems.size(), [&](std::size_t q) {
    targets[q] = std::make_shared<const Targets>(targets_of(problems[q]));
  });
  std::vector<CellResult> all;
  for (const PlannedCell& cell : campaign.cells()) {
    all.push_back({&cell, {}, targets[cell.problem]});
  }
  std::int64_t there = 0;
  each_judged(
      store, [&](const JudgedRun& run) { also(run.stored); },
      [&](const JudgedCell& judged) {
        const PlannedCell* cell = campaign.find(judged.cell);
        if (cell == nullptr) return;
        all[static_cast<std::size_t>(cell - campaign.cells().data())].outcomes = judged.outcomes;
        there += static_cast<std::int64_t>(judged.outcomes.size());
      });
  if (there != campaign.runs()) {
    throw InputError(fmt::format("{} of {} runs are there: the campaign is not at its end", there,
                                 campaign.runs()));
  }
  return all;
}

std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<CellResult>& results) {
  std::map<std::size_t, std::int64_t> largest;
  for (const CellResult& result : results) {
    auto& budget = largest[result.cell->problem];
    budget = std::max(budget, result.cell->cell.budget);
  }
  return largest;
}

const std::string& cluster_of(const Problem& problem) {
  return problem.cluster.empty() ? problem.name : problem.cluster;
}

std::vector<std::size_t> Comparison::problems() const {
  std::vector<std::size_t> all;
  for (const CellResult& result : results) {
    const std::size_t problem = result.cell->problem;
    if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(problem);
  }
  return all;
}

Comparison comparison_of(const Campaign& campaign, const std::vector<CellResult>& results,
                         const Conditions& conditions) {
  const PlanPart& part = campaign.plan().parts[conditions.part];
  Comparison comparison{&campaign, &part, conditions.run, {}};
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const bool asked =
        std::find(cell.parts.begin(), cell.parts.end(), conditions.part) != cell.parts.end() &&
        cell.cell.perturbation == conditions.perturbation &&
        cell.is_at_price(conditions.gradient_price) && conditions.run < cell.seeds;
    if (!asked) continue;
    comparison.results.push_back({&cell,
                                  result.outcomes.every(static_cast<std::size_t>(cell.seeds),
                                                        static_cast<std::size_t>(conditions.run),
                                                        static_cast<std::size_t>(part.instances)),
                                  result.targets});
  }
  return comparison;
}

std::optional<Ceiling> ceiling(const Problem& problem, double smoothing) {
  if (problem.dimension() != 1 || !problem.smoothed || !problem.best_point) return std::nullopt;
  const Problem smooth = problem.smoothed(smoothing);
  const double lower = problem.lower[0];
  const double upper = problem.upper[0];
  // Any infeasible point is worse than every feasible one.
  const auto shown = [&](double x) {
    const TrueValues true_values =
        true_values_of(smooth.evaluate(Vector::Constant(1, x)), problem.equalities);
    return true_values.violation > 0 ? std::numeric_limits<double>::max() : true_values.objective;
  };
  const auto cells =
      static_cast<std::size_t>(std::ceil((upper - lower) / (10 * problem.scan_step)));
  std::vector<double> values(cells + 1);
  const auto at = [&](std::size_t k) {
    return lower + (upper - lower) * static_cast<double>(k) / static_cast<double>(cells);
  };
  tbb::parallel_for(std::size_t{0}, values.size(),
                    [&](std::size_t k) { values[k] = shown(at(k)); });
  const auto best =
      static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
  constexpr int bits = 20;
  const auto [refined, value] = boost::math::tools::brent_find_minima(
      shown, at(best == 0 ? 0 : best - 1), at(std::min(best + 1, cells)), bits);
  const double optimum = value < values[best] ? refined : at(best);
  Ceiling result{optimum, std::abs(optimum - (*problem.best_point)[0]), std::nullopt};
  const TrueValues true_values = true_values_at(problem, Vector::Constant(1, optimum));
  if (true_values.violation <= 0 && problem.best_known)
    result.optimality_gap = true_values.objective - *problem.best_known;
  return result;
}

}  // namespace ricochet::comparison
