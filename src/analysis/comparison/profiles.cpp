#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/analysis/comparison/group.h"
#include "src/analysis/statistics/attainment.h"
#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

/// A row for each problem, a column for each entry.
template <class Cost>
Costs costs_of(const EntrySet& set, const Cost& cost) {
  Costs costs(set.problems.size());
  for (std::size_t q = 0; q < costs.size(); ++q) {
    for (const Entry& entry : set.entries) costs[q].push_back(cost(*entry.results[q]));
  }
  return costs;
}

/// Share of the problems on which the entry's ratio is below 1.
double share_won(const Costs& extended, std::size_t entry) {
  const auto won = std::count_if(extended.begin(), extended.end(),
                                 [&](const auto& row) { return row[entry] < 1; });
  return static_cast<double>(won) / static_cast<double>(extended.size());
}

Json profile_of(const Costs& ratios, std::size_t entry) {
  Json points = Json::array();
  for (int k = 0; k <= 14; ++k) {
    const double ratio = std::pow(2.0, k / 2.0);
    const MeanShare share = performance_profile(ratios, entry, ratio);
    points.push_back({{"ratio", ratio},
                      {"share", share.mean},
                      {"lower", share.interval.lower},
                      {"upper", share.interval.upper}});
  }
  return points;
}

Json profile_of_set(const Campaign& campaign, const EntrySet& set) {
  constexpr std::size_t drawn = 6;
  const Costs times =
      costs_of(set, [&](const CellResult& result) { return running_time(campaign, result); });
  const Costs penalised =
      costs_of(set, [&](const CellResult& result) { return penalised_cost(campaign, result); });
  const Costs ratios = performance_ratios(times);
  const Costs extended = extended_performance_ratios(times);
  const double best = mean_cost(virtual_best(penalised));
  Json rows = Json::array();
  Json profiles = Json::array();
  for (const Entry* entry : cheapest_first(campaign, set)) {
    const auto e = static_cast<std::size_t>(entry - set.entries.data());
    std::vector<double> mine;
    for (const auto& row : penalised) mine.push_back(row[e]);
    const auto within = [&](double ratio) { return performance_profile(ratios, e, ratio).mean; };
    rows.push_back({{"family", set.family},
                    {"solver", entry->solver},
                    {"formulation", entry->formulation},
                    {"problems", set.problems.size()},
                    {"least", within(1)},
                    {"twice", within(2)},
                    {"tenfold", within(10)},
                    {"solved", within(std::numeric_limits<double>::infinity())},
                    {"alone", share_won(extended, e)},
                    {"cost", mean_cost(mine)},
                    {"gap", mean_cost(mine) / best}});
    if (profiles.size() < drawn) {
      profiles.push_back({{"solver", entry->solver},
                          {"formulation", entry->formulation},
                          {"profile", profile_of(ratios, e)}});
    }
  }
  const Json& first = rows.front();
  return {{"family", set.family},
          {"budget", set.budget},
          {"problems", set.problems.size()},
          {"title", fmt::format("{}: {} is within twice the least cost on {:.0f} % of {} problems",
                                set.family, first["solver"].get<std::string>(),
                                100 * first["twice"].get<double>(), set.problems.size())},
          {"single_best", first["solver"]},
          {"single_best_cost", first["cost"]},
          {"virtual_best_cost", best},
          {"gap", first["gap"]},
          {"profiles", std::move(profiles)},
          {"rows", std::move(rows)}};
}

}  // namespace

double running_time(const Campaign& campaign, const CellResult& result) {
  const OnProblem one = on_problem(campaign, result);
  return one.share > 0 ? one.evaluations / one.share : std::numeric_limits<double>::infinity();
}

double penalised_cost(const Outcome& outcome, double budget) {
  if (!outcome.solved()) return 10 * budget;
  return std::max(static_cast<double>(evaluations_until_solved(outcome)), 1.0);
}

double penalised_cost(const Campaign& campaign, const CellResult& result) {
  double sum = 0;
  const auto budget = static_cast<double>(result.cell->budget.evaluations);
  for (const Outcome& outcome : result.outcomes) sum += penalised_cost(outcome, budget);
  const auto& stated = campaign.problems()[result.cell->problem];
  return sum / static_cast<double>(result.outcomes.size()) /
         static_cast<double>(stated.dimension());
}

std::vector<const Entry*> cheapest_first(const Campaign& campaign, const EntrySet& set) {
  std::vector<std::pair<double, const Entry*>> order;
  for (const Entry& entry : set.entries) {
    std::vector<double> costs;
    for (const CellResult* result : entry.results) {
      costs.push_back(penalised_cost(campaign, *result));
    }
    order.emplace_back(mean_cost(costs), &entry);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Entry*> entries;
  for (const auto& [cost, entry] : order) entries.push_back(entry);
  return entries;
}

Json profile_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  return of_solved(sets, [&](const EntrySet& set) { return profile_of_set(campaign, set); });
}

}  // namespace ricochet::studies::comparison
