#include "src/report/site/front_charts.h"

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::site {
namespace {

using report::Chart;
using report::Mark;
using report::Sample;
using report::Scale;
using report::Series;

constexpr int width = 520, height = 360;

std::string file_name(std::string text) {
  for (char& c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (!plain) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : '-';
  }
  return text;
}

/// Returns true if another sample dominates this one.
bool is_beaten(const Sample& sample, const std::vector<Sample>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Sample& other) {
    return other.position <= sample.position && *other.value >= *sample.value &&
           (other.position < sample.position || *other.value > *sample.value);
  });
}

/// The entries of one family with its largest budget.
Chart entries_chart(const Comparison& comparison, std::size_t family) {
  double budget = 0;
  for (const Entry& entry : comparison.entries) {
    if (entry.family == family) budget = std::max(budget, entry.budget);
  }
  const std::string& name = comparison.families[family].name;
  Chart chart{.name = "front-" + file_name(name),
              .title = budget == 0 ? "All families, with the largest budgets"
                                   : fmt::format("{}: {} evaluations a variable", name, budget),
              .x = {"evaluations for each variable", Scale::logarithmic},
              .y = {"success rate [%]", Scale::linear, report::Range{0, 100}},
              .width = width,
              .height = height};
  std::vector<Series> dots;
  std::vector<Sample> places;
  for (const Entry& entry : comparison.entries) {
    const bool fits = entry.family == family && entry.budget == budget && entry.complete;
    if (!fits || entry.evaluations.value_or(0) <= 0 || !entry.solved) continue;
    places.push_back({*entry.evaluations, 100 * *entry.solved});
    dots.push_back(
        {fmt::format("{}, {}", entry.solver, entry.formulation), Mark::points, {places.back()}});
  }
  Series dominated{"others", Mark::points, {}};
  for (Series& dot : dots) {
    if (is_beaten(dot.samples.front(), places)) {
      dominated.samples.push_back(dot.samples.front());
    } else {
      chart.series.push_back(std::move(dot));
    }
  }
  if (!dominated.samples.empty()) chart.series.push_back(std::move(dominated));
  return chart;
}

}  // namespace

std::vector<Chart> front_charts(const Front& front) {
  std::vector<Chart> charts;
  if (front.comparison) {
    for (std::size_t family = 0; family < front.comparison->families.size(); ++family) {
      charts.push_back(entries_chart(*front.comparison, family));
    }
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
  const std::vector<Pair> all = all_pairs(pairs), front = leading(all);
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
