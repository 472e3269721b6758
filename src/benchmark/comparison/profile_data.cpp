#include "src/studies/contest/profile_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/statistics/costs.h"
#include "src/statistics/performance_profile.h"
#include "src/statistics/virtual_best.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

/// A row for each question, an entry for each entrant.
template <class Cost>
Costs costs_of(const Field& field, const Cost& cost) {
  Costs costs(field.questions.size());
  for (std::size_t q = 0; q < costs.size(); ++q) {
    for (const Entrant& entrant : field.entrants) costs[q].push_back(cost(*entrant.standings[q]));
  }
  return costs;
}

/// Share of the questions on which the entrant's ratio is below 1.
double share_won(const Costs& extended, std::size_t entrant) {
  const auto won = std::count_if(extended.begin(), extended.end(),
                                 [&](const auto& row) { return row[entrant] < 1; });
  return static_cast<double>(won) / static_cast<double>(extended.size());
}

Json profile_of(const Costs& ratios, std::size_t entrant) {
  Json points = Json::array();
  for (int k = 0; k <= 14; ++k) {
    const double ratio = std::pow(2.0, k / 2.0);
    const MeanShare share = performance_profile(ratios, entrant, ratio);
    points.push_back({{"ratio", ratio},
                      {"share", share.mean},
                      {"lower", share.interval.lower},
                      {"upper", share.interval.upper}});
  }
  return points;
}

Json profile_of_field(const Campaign& campaign, const Field& field) {
  constexpr std::size_t drawn = 6;
  const Costs times = costs_of(
      field, [&](const StoredStanding& standing) { return running_time(campaign, standing); });
  const Costs penalised = costs_of(
      field, [&](const StoredStanding& standing) { return penalised_cost(campaign, standing); });
  const Costs ratios = performance_ratios(times);
  const Costs extended = extended_performance_ratios(times);
  const double best = mean_cost(virtual_best(penalised));
  Json rows = Json::array();
  Json profiles = Json::array();
  for (const Entrant* entrant : cheapest_first(campaign, field)) {
    const auto e = static_cast<std::size_t>(entrant - field.entrants.data());
    std::vector<double> mine;
    for (const auto& row : penalised) mine.push_back(row[e]);
    const auto within = [&](double ratio) { return performance_profile(ratios, e, ratio).mean; };
    rows.push_back({{"family", field.family},
                    {"solver", entrant->solver},
                    {"form", entrant->form},
                    {"questions", field.questions.size()},
                    {"least", within(1)},
                    {"twice", within(2)},
                    {"tenfold", within(10)},
                    {"solved", within(std::numeric_limits<double>::infinity())},
                    {"alone", share_won(extended, e)},
                    {"cost", mean_cost(mine)},
                    {"gap", mean_cost(mine) / best}});
    if (profiles.size() < drawn) {
      profiles.push_back({{"solver", entrant->solver},
                          {"form", entrant->form},
                          {"profile", profile_of(ratios, e)}});
    }
  }
  const Json& first = rows.front();
  return {{"family", field.family},
          {"budget", field.budget},
          {"questions", field.questions.size()},
          {"title", fmt::format("{}: {} is within twice the least cost on {:.0f} % of {} questions",
                                field.family, first["solver"].get<std::string>(),
                                100 * first["twice"].get<double>(), field.questions.size())},
          {"single_best", first["solver"]},
          {"single_best_cost", first["cost"]},
          {"virtual_best_cost", best},
          {"gap", first["gap"]},
          {"profiles", std::move(profiles)},
          {"rows", std::move(rows)}};
}

}  // namespace

double running_time(const Campaign& campaign, const StoredStanding& standing) {
  const OnQuestion one = on_question(campaign, standing);
  return one.share > 0 ? one.evaluations / one.share : std::numeric_limits<double>::infinity();
}

double penalised_cost(const Campaign& campaign, const StoredStanding& standing) {
  double sum = 0;
  const auto budget = static_cast<double>(standing.cell->budget.evaluations);
  for (const Outcome& outcome : standing.outcomes) {
    sum += outcome.verdict.solved ? std::max(evaluations_of(outcome), 1.0) : 10 * budget;
  }
  const auto& stated = campaign.questions()[standing.cell->question].stated;
  return sum / static_cast<double>(standing.outcomes.size()) /
         static_cast<double>(stated.dimension());
}

std::vector<const Entrant*> cheapest_first(const Campaign& campaign, const Field& field) {
  std::vector<std::pair<double, const Entrant*>> order;
  for (const Entrant& entrant : field.entrants) {
    std::vector<double> costs;
    for (const StoredStanding* standing : entrant.standings) {
      costs.push_back(penalised_cost(campaign, *standing));
    }
    order.emplace_back(mean_cost(costs), &entrant);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Entrant*> entrants;
  for (const auto& [cost, entrant] : order) entrants.push_back(entrant);
  return entrants;
}

Json profile_data(const Campaign& campaign, const std::vector<Field>& fields) {
  return of_compared(fields, [&](const Field& field) { return profile_of_field(campaign, field); });
}

}  // namespace ricochet::studies::contest
