#include "src/report/site/front_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace ricochet::site {
namespace {

using report::Chart;
using report::Mark;
using report::Sample;
using report::Scale;
using report::Series;

constexpr int width = 520, height = 360;

/// Returns true if another sample dominates this one.
bool is_beaten(const Sample& sample, const std::vector<Sample>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Sample& other) {
    return other.position <= sample.position && *other.value >= *sample.value &&
           (other.position < sample.position || *other.value > *sample.value);
  });
}

/// The kind of a solver; nothing if the data have none.
std::string kind_in(const Comparison& comparison, const std::string& solver) {
  const auto kind = comparison.kinds.find(solver);
  return kind == comparison.kinds.end() ? "" : kind->second;
}

/// The entries of one family with its largest budget, by kind. Those on the Pareto front have
/// names, and those that always have.
Chart entries_chart(const Comparison& comparison, std::size_t family) {
  double budget = 0;
  for (const Entry& entry : comparison.entries) {
    if (entry.family == family) budget = std::max(budget, entry.budget);
  }
  Chart chart{.name = "front-speed-accuracy",
              .title = "",
              .x = {"evaluations for each variable", Scale::logarithmic},
              .y = {"success rate [%]", Scale::linear, report::Range{0, 100}},
              .width = width,
              .height = height};
  std::vector<const Entry*> shown;
  std::vector<Sample> places;
  for (const Entry& entry : comparison.entries) {
    const bool fits = entry.family == family && entry.budget == budget && entry.complete;
    if (!fits || entry.evaluations.value_or(0) <= 0 || !entry.solved) continue;
    shown.push_back(&entry);
    places.push_back({*entry.evaluations, 100 * *entry.solved});
  }
  std::map<std::string, Series> kinds;
  const Entry* best = nullptr;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Entry& entry = *shown[i];
    const std::string kind = kind_in(comparison, entry.solver);
    Series& series = kinds.try_emplace(kind, Series{kind, Mark::points, {}}).first->second;
    const bool named = !is_beaten(places[i], places) ||
                       std::ranges::find(always_named, entry.solver) != std::end(always_named);
    series.samples.push_back(places[i]);
    if (named) series.samples.back().name = entry.solver;
    if (best == nullptr || *entry.solved > *best->solved) best = &entry;
  }
  for (auto& [kind, series] : kinds) chart.series.push_back(std::move(series));
  if (best != nullptr) {
    chart.title = fmt::format("{}: {} solves most, {:.0f} % in {:.3g} evaluations a variable",
                              comparison.families[family].name, best->solver, 100 * *best->solved,
                              *best->evaluations);
  }
  return chart;
}

}  // namespace

std::vector<Chart> front_charts(const Front& front) {
  std::vector<Chart> charts;
  if (front.comparison && !front.comparison->families.empty()) {
    charts.push_back(entries_chart(*front.comparison, 0));
  }
  if (front.motion) {
    Chart& chart = charts.emplace_back(front.motion->charts.front());
    chart.name = "front-" + chart.name;
    chart.width = width;
    chart.height = height;
  }
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
}

Chart pairs_chart(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs), front = leading(within_range(pairs));
  Chart chart{
      .name = "front-solver-and-simulation",
      .title = title_of(pairs),
      .x = {"processor time to the threshold, with the fastest solver [s]", Scale::logarithmic},
      .y = {"error of the threshold, at most [rad/s]", Scale::logarithmic},
      .width = 780,
      .height = 420,
      .description = finding_of(pairs)};
  Series line{.label = "none is as fast and as accurate", .mark = Mark::steps, .samples = {}};
  for (const Pair& pair : front) line.samples.push_back({pair.seconds, pair.error});
  if (front.size() > 1) chart.series.push_back(std::move(line));
  for (std::size_t m = 0; m < pairs.simulations.size(); ++m) {
    const std::string& name = pairs.simulations[m].simulation;
    if (m == 0 || pairs.simulations[m - 1].simulation != name) {
      chart.series.push_back({.label = name, .mark = Mark::points, .samples = {}});
    }
    const Pair* fastest = nullptr;
    for (const Pair& pair : all) {
      if (pair.simulation != m) continue;
      if (fastest == nullptr || pair.seconds < fastest->seconds) fastest = &pair;
    }
    const bool leads =
        std::ranges::any_of(front, [&](const Pair& pair) { return pair.simulation == m; });
    Sample dot{fastest->seconds, fastest->error};
    if (leads) dot.name = name_of(pairs, *fastest);
    chart.series.back().samples.push_back(std::move(dot));
  }
  return chart;
}

}  // namespace ricochet::site
