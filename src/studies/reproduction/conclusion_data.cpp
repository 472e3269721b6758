#include <fmt/format.h>

#include <algorithm>

#include "src/report/chart_data.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using report::Json;

std::vector<std::string> names_of(const std::vector<double>& positions) {
  std::vector<std::string> names;
  for (const double position : positions) names.push_back(fmt::format("{}", position));
  return names;
}

Json map_at(const CountGrid& grid, std::size_t disturbance, report::Range colours) {
  report::Chart chart;
  chart.name = fmt::format("grid-{}", disturbance + 1);
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
  Json data = report::data_of(chart);
  data["disturbance"] = grid.disturbances[disturbance];
  return data;
}

/// With the first few of its exceptions, of which all are where it disagrees.
Json data_of(const Trend& trend) {
  constexpr std::size_t shown = 4;
  Json first = Json::array();
  for (const Reversal& e : trend.exceptions) {
    if (first.size() == shown) break;
    first.push_back({{"line", e.line},
                     {"from", e.from},
                     {"to", e.to},
                     {"mean_from", e.mean_from},
                     {"mean_to", e.mean_to}});
  }
  return {{"conclusion", trend.conclusion},
          {"claim", trend.claim},
          {"agree", trend.agree},
          {"disagree", trend.disagree},
          {"changes", trend.agree + trend.disagree},
          {"weakest", trend.weakest},
          {"holds", trend.weakest > 1},
          {"strongest", trend.strongest},
          {"first_exceptions", std::move(first)},
          {"further_exceptions", trend.exceptions.size() > shown}};
}

}  // namespace

Json conclusion_data(const CountGrid& grid, const std::vector<Trend>& trends) {
  Json data = {{"trends", Json::array()}, {"charts", Json::array()}};
  for (const Trend& trend : trends) data["trends"].push_back(data_of(trend));
  const auto [least, most] = std::minmax_element(grid.means.begin(), grid.means.end());
  for (std::size_t d = 0; d < grid.disturbances.size(); ++d) {
    data["charts"].push_back(map_at(grid, d, {*least, *most}));
  }
  return data;
}

}  // namespace ricochet::studies::reproduction
