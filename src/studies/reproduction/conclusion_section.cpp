#include <fmt/format.h>

#include <algorithm>

#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

std::vector<std::string> names_of(const std::vector<double>& positions) {
  std::vector<std::string> names;
  for (const double position : positions) names.push_back(fmt::format("{}", position));
  return names;
}

report::Figure map_at(const CountGrid& grid, std::size_t disturbance, report::Range colours) {
  report::Chart chart;
  chart.name = fmt::format("grid-{}", disturbance + 1);
  chart.title = fmt::format("Disturbance {} N", grid.disturbances[disturbance]);
  chart.x.label = "restitution";
  chart.x.categories = names_of(grid.restitutions);
  chart.y.label = "friction";
  chart.y.categories = names_of(grid.frictions);
  report::HeatMap map{"mean count", {}, colours};
  for (std::size_t f = 0; f < grid.frictions.size(); ++f) {
    auto& row = map.rows.emplace_back();
    for (std::size_t r = 0; r < grid.restitutions.size(); ++r) {
      row.push_back(grid.mean(r, f, disturbance));
    }
  }
  chart.heat_map = std::move(map);
  return {chart, ""};
}

report::Table table_of(const std::vector<Trend>& trends) {
  report::Table table{
      "The paper's conclusions on the grid. Neighbours: pairs of neighbouring points of the grid "
      "at "
      "which the mean count changes as claimed, out of those where it changes. End to end: the "
      "mean count at the end of a line that should have the most over that at the other end, over "
      "all lines.",
      {{"conclusion", report::Alignment::left},
       {"the count", report::Alignment::left},
       {"neighbours as claimed"},
       {"end to end, least"},
       {"end to end, most"}},
      {}};
  for (const Trend& t : trends) {
    const auto state = t.weakest > 1 ? report::State::good : report::State::bad;
    table.rows.push_back({{t.conclusion},
                          {t.claim},
                          {fmt::format("{} of {}", t.agree, t.agree + t.disagree)},
                          {fmt::format("{:.2f} times", t.weakest), state},
                          {fmt::format("{:.2f} times", t.strongest)}});
  }
  return table;
}

std::string exceptions_of(const Trend& trend) {
  constexpr std::size_t shown = 4;
  if (trend.exceptions.empty()) {
    return fmt::format("({}) holds between all neighbours of the grid.", trend.conclusion);
  }
  std::string text =
      fmt::format("({}) does not hold at {} places: ", trend.conclusion, trend.exceptions.size());
  for (std::size_t i = 0; i < std::min(shown, trend.exceptions.size()); ++i) {
    text += (i > 0 ? "; " : "") + trend.exceptions[i];
  }
  return text + (trend.exceptions.size() > shown ? "; and so on." : ".");
}

}  // namespace

report::Section conclusion_section(const CountGrid& grid, const std::vector<Trend>& trends) {
  report::Section section{"conclusions", "Restitution, friction and disturbance"};
  section.paragraphs = {
      "The paper concludes that the count (A) rises sharply with restitution where nothing "
      "disturbs, (B) there falls with friction, and (C) rises sharply with the disturbance "
      "whatever "
      "the others. Tested on a grid, by the mean count over evenly spaced speeds up to 18 rad/s."};
  for (const Trend& t : trends) section.paragraphs.push_back(exceptions_of(t));
  section.tables = {table_of(trends)};
  const auto [least, most] = std::minmax_element(grid.means.begin(), grid.means.end());
  for (std::size_t d = 0; d < grid.disturbances.size(); ++d) {
    section.figures.push_back(map_at(grid, d, {*least, *most}));
  }
  return section;
}

}  // namespace ricochet::studies::reproduction
