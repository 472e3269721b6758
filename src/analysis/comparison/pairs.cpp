#include "src/analysis/comparison/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/statistics/attainment.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/core/instance.h"

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

namespace {

/// Place of an entry among the ranked ones, 1 the first; null if it is none of them.
Json place_of(const Rating& wanted, const std::vector<Rating>& ratings) {
  for (std::size_t k = 0; k < ratings.size() && ratings[k].rank; ++k) {
    const Rating& rating = ratings[k];
    if (rating.solver == wanted.solver && rating.formulation == wanted.formulation) return k + 1;
  }
  return {};
}

}  // namespace

Json agreement_data(const Campaign& first, const std::vector<CellResult>& of_first,
                    const Campaign& second, const std::vector<CellResult>& of_second) {
  const std::vector<RatedFamily> others = rated_families(second, of_second);
  Json rows = Json::array();
  for (const RatedFamily& rated : rated_families(first, of_first)) {
    const auto other = std::ranges::find(others, rated.name, &RatedFamily::name);
    if (other == others.end()) continue;
    const Order order = order_of(rated.ratings);
    const Order other_order = order_of(other->ratings);
    const Rating* leader = leader_of(rated.ratings);
    rows.push_back({{"family", rated.name},
                    {"problems", rated.problems},
                    {"other_problems", other->problems},
                    {"agreement", agreement_of(order, other_order)},
                    {"leader", order.leader},
                    {"best", leader != nullptr ? Json(leader->probability_of_being_best) : Json()},
                    {"place", leader != nullptr ? place_of(*leader, other->ratings) : Json()},
                    {"other_leader", other_order.leader}});
  }
  return rows;
}

namespace {

Json log_ratios_of(const Campaign& campaign, const EntrySet& set) {
  const std::vector<const Entry*> best = cheapest_first(campaign, set);
  const Entry& a = *best[0];
  const Entry& b = *best[1];
  std::vector<double> costs_of_a;
  std::vector<double> costs_of_b;
  for (std::size_t q = 0; q < set.problems.size(); ++q) {
    costs_of_a.push_back(running_time(campaign, *a.results[q]));
    costs_of_b.push_back(running_time(campaign, *b.results[q]));
  }
  const std::array names{std::string("both solve it"), "only " + a.solver, "only " + b.solver,
                         std::string("neither does")};
  std::array<Json, 4> bars;
  for (Json& one : bars) one = Json::array();
  int ahead_a = 0;
  int ahead_b = 0;
  int place = 0;
  for (const LogRatio& bar : log_ratio_profile(costs_of_a, costs_of_b)) {
    ++place;
    const auto kind = static_cast<std::size_t>(bar.solved_by);
    bars[kind].push_back({{"place", place},
                          {"problem", campaign.problems()[set.problems[bar.problem]].name},
                          {"log2_ratio", bar.log2_ratio},
                          {"lower", std::min(bar.log2_ratio, 0.0)},
                          {"upper", std::max(bar.log2_ratio, 0.0)}});
    if (bar.solved_by == SolvedBy::neither) continue;
    if (bar.log2_ratio < 0) ++ahead_a;
    if (bar.log2_ratio > 0) ++ahead_b;
  }
  Json kinds = Json::array();
  for (std::size_t k = 0; k < bars.size(); ++k) {
    if (!bars[k].empty()) kinds.push_back({{"solved_by", names[k]}, {"bars", std::move(bars[k])}});
  }
  return {{"family", set.family},
          {"a", a.solver},
          {"b", b.solver},
          {"formulation_a", a.formulation},
          {"formulation_b", b.formulation},
          {"ahead_a", ahead_a},
          {"ahead_b", ahead_b},
          {"problems", set.problems.size()},
          {"title", fmt::format("{}: {} needs less than {} on {} of {} problems", set.family,
                                a.solver, b.solver, ahead_a, set.problems.size())},
          {"kinds", std::move(kinds)}};
}

}  // namespace

Json log_ratio_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  return of_solved(sets, [&](const EntrySet& set) { return log_ratios_of(campaign, set); });
}

namespace {

constexpr double solving_share = 0.5;  // of the runs
constexpr double significant_split = 0.05;
constexpr std::size_t fewest = 3;  // entries with a property, and without

struct Solved {
  const Solver* solver;
  std::string formulation;
  double share;
};

struct Property {
  std::string name;
  std::function<bool(const Solved&)> holds;
};

std::vector<Property> properties_of(const std::vector<Solved>& entries) {
  std::vector<Property> properties = {
      {"gradients",
       [](const Solved& entry) {
         return entry.solver->capabilities.derivatives != Capabilities::Order::value;
       }},
      {"stochastic", [](const Solved& entry) { return entry.solver->stochastic; }}};
  std::set<std::string> formulations;
  for (const Solved& entry : entries) formulations.insert(entry.formulation);
  for (const std::string& formulation : formulations) {
    properties.push_back({"formulation " + formulation, [formulation](const Solved& entry) {
                            return entry.formulation == formulation;
                          }});
  }
  return properties;
}

double mean(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
}

struct Split {
  std::string name;
  std::vector<double> those, others;  ///< success rates with and without the property
};

std::vector<Split> splits_of(const std::vector<Solved>& entries) {
  std::vector<Split> splits;
  for (const Property& property : properties_of(entries)) {
    Split split{property.name, {}, {}};
    for (const Solved& entry : entries) {
      (property.holds(entry) ? split.those : split.others).push_back(entry.share);
    }
    if (std::min(split.those.size(), split.others.size()) >= fewest) splits.push_back(split);
  }
  return splits;
}

}  // namespace

Json separation_data(const Comparison& comparison, std::size_t problem) {
  std::vector<Solved> entries;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    if (result.cell->problem != problem || cell.budget != comparison.part->budgets.back()) continue;
    Share solved{};
    add_runs(solved, result);
    entries.push_back({&comparison.campaign->solvers()[result.cell->solver], cell.formulation,
                       static_cast<double>(solved.successes) / solved.trials});
  }
  Json data = {
      {"entries", entries.size()},
      {"solving", std::ranges::count_if(
                      entries, [](const Solved& entry) { return entry.share >= solving_share; })},
      {"separates", nullptr},
      {"those", nullptr},
      {"others", nullptr}};
  const std::vector<Split> splits = splits_of(entries);
  std::vector<double> p_values;
  for (const Split& split : splits) {
    p_values.push_back(rank_sum_test(split.those, split.others).p_value);
  }
  p_values = holm(p_values);
  const auto least = std::ranges::min_element(p_values);
  if (least == p_values.end() || *least >= significant_split) return data;
  const Split& split = splits[static_cast<std::size_t>(least - p_values.begin())];
  data["separates"] = split.name;
  data["those"] = mean(split.those);
  data["others"] = mean(split.others);
  return data;
}

}  // namespace ricochet::studies::comparison
