#include "src/analysis/comparison/profiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/profiles.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::Mark;
using report::Range;
using report::Scale;
using report::Series;

/// A row for each problem, a column for each entry.
template <class Cost>
Costs costs_of(const EntrySet& set, const Cost& cost) {
  Costs costs(set.problems.size());
  for (std::size_t q = 0; q < costs.size(); ++q) {
    for (const Entry& entry : set.entries) costs[q].push_back(cost(*entry.results[q]));
  }
  return costs;
}

/// The share of problems [%] within a factor of the least cost, over the factor.
Series profile_of(const Costs& ratios, std::size_t entry, const std::string& name) {
  Series profile{name, Mark::steps, {}};
  for (int k = 0; k <= 14; ++k) {
    const double ratio = std::pow(2.0, k / 2.0);
    profile.samples.push_back({ratio, 100 * performance_profile(ratios, entry, ratio)});
  }
  return profile;
}

}  // namespace

void add_profiles(const Campaign& campaign, const EntrySet& set, report::Results& page) {
  constexpr std::size_t drawn = 6;
  const Costs times =
      costs_of(set, [&](const CellResult& result) { return running_time(campaign, result); });
  const Costs penalised =
      costs_of(set, [&](const CellResult& result) { return penalised_cost(campaign, result); });
  const Costs ratios = performance_ratios(times);
  const double best = mean_cost(virtual_best(penalised));
  Table table{"profile",
              {{"solver"},
               {"formulation"},
               {"least", "least [%]", ".0%"},
               {"twice", "at most twice [%]", ".0%"},
               {"tenfold", "at most tenfold [%]", ".0%"},
               {"solved", "solved [%]", ".0%"},
               {"cost", "PAR10 [evaluations a variable]", ".3g"},
               {"gap", "times the virtual best's", ".2g", 3}}};
  Chart chart{.name = "profile",
              .x = {"ratio to the least expected evaluations of any solver", Scale::logarithmic},
              .y = {"problems [%]", Scale::linear, Range{0, 100}},
              .width = 820,
              .height = 380};
  const std::vector<const Entry*> order = cheapest_first(campaign, set);
  for (const Entry* entry : order) {
    const auto e = static_cast<std::size_t>(entry - set.entries.data());
    std::vector<double> mine;
    for (const auto& row : penalised) mine.push_back(row[e]);
    const auto within = [&](double ratio) { return performance_profile(ratios, e, ratio); };
    table.add(entry->solver, entry->formulation, within(1), within(2), within(10),
              within(std::numeric_limits<double>::infinity()), mean_cost(mine),
              mean_cost(mine) / best);
    if (chart.series.size() < drawn) {
      chart.series.push_back(
          profile_of(ratios, e, ricochet::comparison::entry(entry->solver, entry->formulation)));
    }
  }
  const Row first = table[0];
  chart.title =
      fmt::format("{}: {} is within twice the least cost on {:.0f} % of {} problems", set.family,
                  first.text("solver"), 100 * first.number("twice"), set.problems.size());
  page.set("virtual-best",
           fmt::format("The single best by PAR10 is {}, with {:.3g} evaluations a variable, {:.2g} "
                       "times the virtual best's {:.3g}.",
                       first.text("solver"), first.number("cost"), first.number("gap"), best));
  page.add(std::move(table));
  page.add(std::move(chart));
}

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

}  // namespace ricochet::studies::comparison
