#include "src/report/site/machine_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <utility>

#include "embedded/page_machines.h"
#include "src/report/markdown_page.h"

namespace ricochet::site {

namespace {

constexpr double shown_to = 14;  ///< [rad/s], at least, of the chart
constexpr double half_column = 0.42;
constexpr double rpm = 30 / std::numbers::pi;  ///< of 1 rad/s

std::optional<std::pair<double, double>> quiet_range(const ricochet::Table& thresholds) {
  std::optional<std::pair<double, double>> range;
  each_row(thresholds, [&](const Row& row) {
    const auto quiet = row.number_if("quiet_up_to");
    if (!quiet) return;
    if (!range) range = {*quiet, *quiet};
    range->first = std::min(range->first, *quiet);
    range->second = std::max(range->second, *quiet);
  });
  return range;
}

}  // namespace

Place machine_place() {
  const report::PageSource source = report::page_source(embedded::page_machines);
  return {source.keys.at("group"), source.keys.at("label"), "machine"};
}

OwnFiles machine_page(report::Results site) {
  if (const ricochet::Table* thresholds = site.table("reproduction-thresholds")) {
    site.set("speed", speed_sentence(*thresholds));
    site.add(regimes_chart(*thresholds));
  }
  auto [files, failures] = page_files(report::page_source(embedded::page_machines), site);
  std::erase_if(files, [](const auto& file) { return file.first.ends_with(".csv"); });
  return {std::move(files), std::move(failures)};
}

report::Chart regimes_chart(const ricochet::Table& thresholds) {
  const auto range = quiet_range(thresholds);
  const double top = std::max(shown_to, range ? range->second + 1 : 0);
  report::Chart chart{
      .name = "regimes-of-the-machines",
      .title = "How fast the paper's machines are silent, quiet and loud",
      .x = {.label = ""},
      .y = {.label = "speed of the driver plate [rad/s]", .range = report::Range{0, top}},
      .areas = {{"silent: no collision that counts", 1.0, {}, ""},
                {"quiet: at most two a turn", 0.72, {}, ""},
                {"loud: more", 0.12, {}, ""}},
      .width = 720,
      .height = 360};
  report::Series paper{
      .label = "the paper's threshold", .mark = report::Mark::points, .samples = {}, .dark = true};
  each_row(thresholds, [&](const Row& row) {
    const auto at = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(row.text("case"));
    const double silent = row.number_if("silent_up_to").value_or(0);
    const double quiet = std::max(row.number_if("quiet_up_to").value_or(0), silent);
    const double borders[] = {0, silent, quiet, top};
    for (std::size_t i = 0; i < chart.areas.size(); ++i) {
      if (borders[i + 1] <= borders[i]) continue;
      const report::Range between{borders[i], borders[i + 1]};
      chart.areas[i].parts.push_back({{at - half_column, between}, {at + half_column, between}});
    }
    if (const auto claimed = row.number_if("paper_threshold")) {
      paper.samples.push_back({at, claimed});
    }
  });
  if (!paper.samples.empty()) chart.series.push_back(std::move(paper));
  chart.description =
      "Columns of the paper's machines over speed: silent, quiet and loud, with the paper's "
      "thresholds as points. " +
      speed_sentence(thresholds).value_or("");
  return chart;
}

std::optional<std::string> speed_sentence(const ricochet::Table& thresholds) {
  const auto range = quiet_range(thresholds);
  if (!range) return std::nullopt;
  return fmt::format(
      "The paper's {} machines stay quiet up to {:.1f} to {:.1f} rad/s ({:.0f} to {:.0f} rpm): at "
      "most two collisions a turn, one with each wall.",
      thresholds.rows.size(), range->first, range->second, range->first * rpm, range->second * rpm);
}

}  // namespace ricochet::site
