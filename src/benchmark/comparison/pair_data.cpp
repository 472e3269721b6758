#include "src/studies/contest/pair_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/core/seed.h"
#include "src/statistics/attainment_function.h"
#include "src/statistics/bayesian_signed_rank.h"
#include "src/statistics/holm.h"
#include "src/statistics/rank_sum_test.h"
#include "src/studies/contest/profile_data.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

constexpr double never = std::numeric_limits<double>::infinity();

/// The question's tolerance; where it has none, hardly more.
double tolerance_of(const Question& question) {
  return std::max(question.tolerance, 1e-12);
}

/// Differences of the median regrets in tolerances, one a question; 0 where both are infinite.
std::vector<double> differences(const Campaign& campaign, const Entrant& a, const Entrant& b) {
  std::vector<double> all;
  for (std::size_t q = 0; q < a.standings.size(); ++q) {
    const double tolerance = tolerance_of(campaign.questions()[a.standings[q]->cell->question]);
    const double of_a = on_question(campaign, *a.standings[q]).regret;
    const double of_b = on_question(campaign, *b.standings[q]).regret;
    all.push_back(of_a == of_b ? 0 : (of_a - of_b) / tolerance);
  }
  return all;
}

/// Evaluations until each run solved its question; infinite where it did not.
std::vector<double> times_of(const StoredStanding& standing) {
  std::vector<double> times;
  for (const Outcome& outcome : standing.outcomes) {
    times.push_back(outcome.verdict.solved ? evaluations_of(outcome) : never);
  }
  return times;
}

/// The improvements of all runs, in evaluations of a question of `variables` and in tolerances.
RunsOfUnits histories_of(const Campaign& campaign, const Entrant& entrant, double variables) {
  RunsOfUnits units;
  for (const StoredStanding* standing : entrant.standings) {
    const Question& question = campaign.questions()[standing->cell->question];
    const double longer = variables / static_cast<double>(question.stated.dimension());
    auto& runs = units.emplace_back();
    for (const Outcome& outcome : standing->outcomes) {
      History& history = runs.emplace_back();
      for (const Step& step : outcome.steps) {
        const double at = longer * static_cast<double>(step.evaluations);
        const double value = step.regret / tolerance_of(question);
        const bool improves =
            history.empty() || (value < history.back().value && at > history.back().evaluations);
        if (improves) history.push_back({at, value});
      }
    }
  }
  return units;
}

/// Where one of the two is ahead: a row for each regret, a cell for each number of evaluations.
Json map_of(const Campaign& campaign, const Field& field, const Entrant& a, const Entrant& b) {
  double variables = 1;
  for (const std::size_t q : field.questions) {
    variables =
        std::max(variables, static_cast<double>(campaign.questions()[q].stated.dimension()));
  }
  AttainmentGrid grid{{}, {1, 3, 5, 9, 17, 100, 1000}};
  Json places = Json::array();
  for (double t = 1; t < 1.001 * static_cast<double>(field.budget); t *= std::sqrt(std::sqrt(10))) {
    grid.evaluations.push_back(t * variables);
    places.push_back({{"evaluations", t}});
  }
  const auto difference = attainment_difference(histories_of(campaign, a, variables),
                                                histories_of(campaign, b, variables), grid);
  Json rows = Json::array();
  double most = 0;  // leads that are sure, in what is solved
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
    rows.push_back({{"regret", grid.values[v]}, {"cells", std::move(cells)}});
  }
  const bool first = most >= -least;
  const std::string title = most == least
                                ? fmt::format("{}: nothing tells {} from {} in what they solve",
                                              field.family, a.solver, b.solver)
                                : fmt::format("{}: {} solves up to {:.0f} points more than {}",
                                              field.family, (first ? a : b).solver,
                                              100 * std::max(most, -least), (first ? b : a).solver);
  return {{"title", title},
          {"a", a.solver},
          {"b", b.solver},
          {"sure", sure},
          {"all_cells", grid.values.size() * grid.evaluations.size()},
          {"places", std::move(places)},
          {"rows", std::move(rows)}};
}

Json field_data(const Campaign& campaign, const Field& field) {
  constexpr std::size_t compared = 4;
  std::vector<const Entrant*> best = cheapest_first(campaign, field);
  best.resize(std::min(compared, best.size()));
  Json pairs = Json::array();
  std::vector<double> p_values;
  std::vector<double> faster;  // P(a is faster than b), for each p-value
  for (std::size_t i = 0; i < best.size(); ++i) {
    for (std::size_t k = i + 1; k < best.size(); ++k) {
      const Entrant& a = *best[i];
      const Entrant& b = *best[k];
      const SignedRankPosterior posterior = bayesian_signed_rank(
          differences(campaign, a, b), 1,
          seed_of("pairs", field.family, static_cast<int>(i * compared + k), 0));
      pairs.push_back({{"family", field.family},
                       {"a", a.solver},
                       {"b", b.solver},
                       {"questions", field.questions.size()},
                       {"better", posterior.negative},
                       {"equivalent", posterior.equivalent},
                       {"worse", posterior.positive}});
      for (std::size_t q = 0; q < field.questions.size(); ++q) {
        const RankSumTest test =
            rank_sum_test(times_of(*a.standings[q]), times_of(*b.standings[q]));
        p_values.push_back(test.p_value);
        faster.push_back(test.smaller);
      }
    }
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    int a_faster = 0;
    int b_faster = 0;
    for (std::size_t q = 0; q < field.questions.size(); ++q) {
      const std::size_t test = pair * field.questions.size() + q;
      if (adjusted[test] >= 0.05) continue;
      ++(faster[test] > 0.5 ? a_faster : b_faster);
    }
    pairs[pair]["a_faster"] = a_faster;
    pairs[pair]["b_faster"] = b_faster;
  }
  return {{"family", field.family},
          {"budget", field.budget},
          {"map", map_of(campaign, field, *best[0], *best[1])},
          {"pairs", std::move(pairs)}};
}

}  // namespace

Json pair_data(const Campaign& campaign, const std::vector<Field>& fields) {
  return of_compared(fields, [&](const Field& field) { return field_data(campaign, field); });
}

}  // namespace ricochet::studies::contest
