#pragma once

#include "src/report/chart.h"

namespace ricochet::report {

inline Chart line_chart(const std::vector<Sample>& samples) {
  return {.name = "chart",
          .title = "A title",
          .x = {.label = "time [s]"},
          .y = {.label = "x [mm]"},
          .series = {{"path", Mark::line, samples}}};
}

inline Chart heat_map_chart(const std::vector<std::vector<std::optional<double>>>& rows) {
  Chart chart{
      .name = "map", .title = "A map", .x = {.label = "restitution"}, .y = {.label = "friction"}};
  for (std::size_t i = 0; i < rows.size(); ++i)
    chart.y.categories.push_back("r" + std::to_string(i));
  for (std::size_t i = 0; i < rows.front().size(); ++i)
    chart.x.categories.push_back("c" + std::to_string(i));
  chart.heat_map = HeatMap{"threshold [rad/s]", rows};
  return chart;
}

}  // namespace ricochet::report
