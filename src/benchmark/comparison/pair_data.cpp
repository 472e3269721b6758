#include "src/benchmark/comparison/pair_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/benchmark/comparison/profile_data.h"
#include "src/benchmark/statistics/attainment_function.h"
#include "src/benchmark/statistics/bayesian_signed_rank.h"
#include "src/benchmark/statistics/holm.h"
#include "src/benchmark/statistics/rank_sum_test.h"
#include "src/core/seed.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr double never = std::numeric_limits<double>::infinity();

/// Returns the problem's tolerance, or a very small one if it has none.
double tolerance_of(const Problem& problem) {
  return std::max(problem.tolerance, 1e-12);
}

/// Differences of the median optimality gaps in units of the tolerance, one for each problem; 0 if
/// both are infinite.
std::vector<double> differences(const Campaign& campaign, const Entry& a, const Entry& b) {
  std::vector<double> all;
  for (std::size_t q = 0; q < a.results.size(); ++q) {
    const double tolerance = tolerance_of(campaign.problems()[a.results[q]->cell->problem]);
    const double of_a = on_problem(campaign, *a.results[q]).optimality_gap;
    const double of_b = on_problem(campaign, *b.results[q]).optimality_gap;
    all.push_back(of_a == of_b ? 0 : (of_a - of_b) / tolerance);
  }
  return all;
}

/// Evaluations until each run solved its problem; infinite if it did not.
std::vector<double> times_of(const CellResult& result) {
  std::vector<double> times;
  for (const Outcome& outcome : result.outcomes) {
    times.push_back(outcome.solved() ? static_cast<double>(evaluations_until_solved(outcome))
                                     : never);
  }
  return times;
}

/// The improvements of all runs as far as their returned points, with evaluations per variable and
/// optimality gaps in tolerances.
RunsOfUnits histories_of(const Campaign& campaign, const Entry& entry, double variables) {
  RunsOfUnits units;
  for (const CellResult* result : entry.results) {
    const Problem& problem = campaign.problems()[result->cell->problem];
    const double longer = variables / static_cast<double>(problem.dimension());
    auto& runs = units.emplace_back();
    for (const Outcome& outcome : result->outcomes) {
      History& history = runs.emplace_back();
      for (const Step& step : steps_of(outcome)) {
        const double at = longer * static_cast<double>(step.evaluations);
        const double value = step.optimality_gap / tolerance_of(problem);
        const bool improves =
            history.empty() || (value < history.back().value && at > history.back().evaluations);
        if (improves) history.push_back({at, value});
      }
    }
  }
  return units;
}

/// Shows which of the two is ahead: a row for each optimality gap, a column for each number of
/// evaluations.
Json map_of(const Campaign& campaign, const EntrySet& set, const Entry& a, const Entry& b) {
  double variables = 1;
  for (const std::size_t q : set.problems) {
    variables = std::max(variables, static_cast<double>(campaign.problems()[q].dimension()));
  }
  AttainmentGrid grid{{}, {1, 3, 5, 9, 17, 100, 1000}};
  Json places = Json::array();
  for (double t = 1; t < 1.001 * static_cast<double>(set.budget); t *= std::sqrt(std::sqrt(10))) {
    grid.evaluations.push_back(t * variables);
    places.push_back({{"evaluations", t}});
  }
  const auto difference = attainment_difference(histories_of(campaign, a, variables),
                                                histories_of(campaign, b, variables), grid);
  Json rows = Json::array();
  double most = 0;  // significant leads, in the share solved
  double least = 0;
  int sure = 0;
  for (std::size_t v = 0; v < grid.values.size(); ++v) {
    Json cells = Json::array();
    for (std::size_t t = 0; t < grid.evaluations.size(); ++t) {
      const Attained& one = difference[t][v];
      cells.push_back(one.share);
      if (one.interval.lower <= 0 && one.interval.upper >= 0) continue;
      ++sure;
      if (v > 0) continue;
      most = std::max(most, one.share);
      least = std::min(least, one.share);
    }
    rows.push_back({{"optimality_gap", grid.values[v]}, {"cells", std::move(cells)}});
  }
  const bool first = most >= -least;
  const std::string title = most == least
                                ? fmt::format("{}: nothing tells {} from {} in what they solve",
                                              set.family, a.solver, b.solver)
                                : fmt::format("{}: {} solves up to {:.0f} points more than {}",
                                              set.family, (first ? a : b).solver,
                                              100 * std::max(most, -least), (first ? b : a).solver);
  return {{"title", title},
          {"a", a.solver},
          {"b", b.solver},
          {"sure", sure},
          {"all_cells", grid.values.size() * grid.evaluations.size()},
          {"places", std::move(places)},
          {"rows", std::move(rows)}};
}

Json entry_set_data(const Campaign& campaign, const EntrySet& set) {
  constexpr std::size_t compared = 4;
  std::vector<const Entry*> best = cheapest_first(campaign, set);
  best.resize(std::min(compared, best.size()));
  Json pairs = Json::array();
  std::vector<double> p_values;
  std::vector<double> faster;  // P(a is faster than b), for each p-value
  for (std::size_t i = 0; i < best.size(); ++i) {
    for (std::size_t k = i + 1; k < best.size(); ++k) {
      const Entry& a = *best[i];
      const Entry& b = *best[k];
      const SignedRankPosterior posterior =
          bayesian_signed_rank(differences(campaign, a, b), 1,
                               seed_of("pairs", set.family, static_cast<int>(i * compared + k), 0));
      pairs.push_back({{"family", set.family},
                       {"a", a.solver},
                       {"b", b.solver},
                       {"problems", set.problems.size()},
                       {"better", posterior.negative},
                       {"equivalent", posterior.equivalent},
                       {"worse", posterior.positive}});
      for (std::size_t q = 0; q < set.problems.size(); ++q) {
        const RankSumTest test = rank_sum_test(times_of(*a.results[q]), times_of(*b.results[q]));
        p_values.push_back(test.p_value);
        faster.push_back(test.smaller);
      }
    }
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    int a_faster = 0;
    int b_faster = 0;
    for (std::size_t q = 0; q < set.problems.size(); ++q) {
      const std::size_t test = pair * set.problems.size() + q;
      if (adjusted[test] >= 0.05) continue;
      ++(faster[test] > 0.5 ? a_faster : b_faster);
    }
    pairs[pair]["a_faster"] = a_faster;
    pairs[pair]["b_faster"] = b_faster;
  }
  return {{"family", set.family},
          {"budget", set.budget},
          {"map", map_of(campaign, set, *best[0], *best[1])},
          {"pairs", std::move(pairs)}};
}

}  // namespace

Json pair_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  return of_compared(sets, [&](const EntrySet& set) { return entry_set_data(campaign, set); });
}

}  // namespace ricochet::studies::comparison
