#include "src/studies/reproduction/conclusions.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "problems/carrier_track/counting/threshold.h"
#include "src/core/progress.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

namespace {

using carrier_track::Scene;

/// Follows one line of the grid; `means` begins at the end where the claim says the count is
/// smallest.
void walk(Trend& trend, const std::vector<double>& means, const std::vector<double>& positions,
          const std::string& line) {
  for (std::size_t i = 0; i + 1 < means.size(); ++i) {
    if (means[i + 1] > means[i]) ++trend.agree;
    if (means[i + 1] < means[i]) {
      ++trend.disagree;
      trend.exceptions.push_back({line, positions[i], positions[i + 1], means[i], means[i + 1]});
    }
  }
  const double ratio = means.back() / means.front();
  const bool first = trend.weakest == 0;
  trend.weakest = first ? ratio : std::min(trend.weakest, ratio);
  trend.strongest = first ? ratio : std::max(trend.strongest, ratio);
}

template <class At>
std::vector<double> line_of(std::size_t size, At at) {
  std::vector<double> line;
  for (std::size_t i = 0; i < size; ++i) line.push_back(at(i));
  return line;
}

}  // namespace

double CountGrid::mean(std::size_t restitution, std::size_t friction,
                       std::size_t disturbance) const {
  return means[(disturbance * frictions.size() + friction) * restitutions.size() + restitution];
}

CountGrid count_grid(const Scene& interpretation, double step, bool coarse) {
  CountGrid grid;
  grid.restitutions = coarse ? std::vector{0.1, 0.3, 0.5, 0.7, 0.9}
                             : std::vector{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
  grid.frictions = coarse ? std::vector{0.1, 0.2, 0.3, 0.4}
                          : std::vector{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4};
  grid.disturbances = coarse ? std::vector{0.0, 0.1, 1.0} : std::vector{0.0, 0.1, 0.3, 1.0};
  const std::size_t rows = grid.restitutions.size() * grid.frictions.size();
  grid.means.resize(rows * grid.disturbances.size());
  Progress progress("counting over the grid", static_cast<double>(grid.means.size()));
  tbb::parallel_for(std::size_t{0}, grid.means.size(), [&](std::size_t i) {
    Scene scene = interpretation;
    scene.restitution_lower = scene.restitution_upper =
        grid.restitutions[i % grid.restitutions.size()];
    scene.friction = grid.frictions[i % rows / grid.restitutions.size()];
    scene.disturbance = grid.disturbances[i / rows];
    const auto counts = carrier_track::scan_speeds(scene, step, 18.0).counts;
    grid.means[i] =
        std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
    progress.advance(1);
  });
  return grid;
}

std::vector<Trend> trends(const CountGrid& grid) {
  Trend a{"A", "rises with restitution, without disturbance"};
  Trend b{"B", "falls with friction, without disturbance"};
  Trend c{"C", "rises with the disturbance, whatever the other parameters"};
  for (std::size_t f = 0; f < grid.frictions.size(); ++f) {
    walk(a, line_of(grid.restitutions.size(), [&](std::size_t i) { return grid.mean(i, f, 0); }),
         grid.restitutions, fmt::format("friction {}", grid.frictions[f]));
  }
  std::vector<double> falling = grid.frictions;
  std::reverse(falling.begin(), falling.end());
  for (std::size_t r = 0; r < grid.restitutions.size(); ++r) {
    const std::size_t last = grid.frictions.size() - 1;
    walk(b, line_of(last + 1, [&](std::size_t i) { return grid.mean(r, last - i, 0); }), falling,
         fmt::format("restitution {}", grid.restitutions[r]));
    for (std::size_t f = 0; f <= last; ++f) {
      walk(c, line_of(grid.disturbances.size(), [&](std::size_t i) { return grid.mean(r, f, i); }),
           grid.disturbances,
           fmt::format("restitution {}, friction {}", grid.restitutions[r], grid.frictions[f]));
    }
  }
  return {a, b, c};
}

namespace {

/// The mean counts at a disturbance.
report::Chart grid_chart(std::string name, const CountGrid& grid, std::size_t disturbance) {
  const auto [least, most] = std::ranges::minmax(grid.means);
  const auto ends = [&](std::size_t friction) {
    return fmt::format("{:.2g} to {:.2g} at friction {}", grid.mean(0, friction, disturbance),
                       grid.mean(grid.restitutions.size() - 1, friction, disturbance),
                       grid.frictions[friction]);
  };
  report::Chart chart{
      .name = std::move(name),
      .title = fmt::format("Disturbance {} N: from restitution {} to {} the mean count goes from "
                           "{}, from {}",
                           grid.disturbances[disturbance], grid.restitutions.front(),
                           grid.restitutions.back(), ends(0), ends(grid.frictions.size() - 1)),
      .x = {.label = "restitution"},
      .y = {.label = "friction"},
      .heat_map = report::HeatMap{"mean count", {}, report::Range{least, most}}};
  for (const double restitution : grid.restitutions)
    chart.x.categories.push_back(fmt::format("{}", restitution));
  for (std::size_t f = 0; f < grid.frictions.size(); ++f) {
    chart.y.categories.push_back(fmt::format("{}", grid.frictions[f]));
    auto& row = chart.heat_map->rows.emplace_back();
    for (std::size_t r = 0; r < grid.restitutions.size(); ++r)
      row.emplace_back(grid.mean(r, f, disturbance));
  }
  return chart;
}

/// Where a conclusion fails, and where it holds everywhere.
std::string told(const Trend& trend) {
  const int changes = trend.agree + trend.disagree;
  if (trend.disagree == 0)
    return fmt::format("({}) holds between all {} neighbours that differ.", trend.conclusion,
                       changes);
  const Reversal& first = trend.exceptions.front();
  return fmt::format(
      "({}) fails between {} of {}, such as {}, from {} to {}: {:.2f} to {:.2f}; from end to end "
      "the count rises by {:.0f} % at most.",
      trend.conclusion, trend.disagree, changes, first.line, first.from, first.to, first.mean_from,
      first.mean_to, 100 * (trend.strongest - 1));
}

}  // namespace

void add_conclusions(const CountGrid& grid, const std::vector<Trend>& trends,
                     report::Results& results) {
  Table table{"conclusions",
              {{"conclusion"},
               {"claim", "the count"},
               {"agree", "neighbours as claimed"},
               {"disagree", "against"},
               {"weakest", "end to end, least (times)", ".2f"},
               {"strongest", "most (times)", ".2f"}}};
  std::string text;
  for (const Trend& trend : trends) {
    table.add(trend.conclusion, trend.claim, trend.agree, trend.disagree, trend.weakest,
              trend.strongest);
    text += (text.empty() ? "" : " ") + told(trend);
  }
  results.set("conclusions", text);
  results.add(std::move(table));
  results.add(grid_chart("grid-least", grid, 0));
  results.add(grid_chart("grid-most", grid, grid.disturbances.size() - 1));
}

}  // namespace ricochet::studies::reproduction
