#include "src/studies/reproduction/path_chart.h"

#include <cmath>
#include <numbers>

namespace ricochet::studies::reproduction {

report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title) {
  constexpr double millimetre = 1e-3;
  const bool turns =
      std::holds_alternative<carrier_track::Revolutions>(scene.window) && scene.profile.empty();
  const double unit = turns ? 2 * std::numbers::pi / scene.omega : 1.0;
  report::Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = turns ? "driver plate [turns]" : "time [s]";
  chart.y.label = "x [mm]";
  report::Series path{"", report::Mark::line, {}};
  double last = -1;
  for (const carrier_track::Sample& s : recording.path) {
    if (s.time <= last) continue;  // an impact has two samples, before and after
    last = s.time;
    path.samples.push_back({s.time / unit, s.position / millimetre});
  }
  chart.series = {std::move(path)};
  const double lower = scene.wall_lower / millimetre;
  const double upper = scene.wall_upper / millimetre;
  chart.lines = {{report::Direction::horizontal, lower, "wall"}};
  if (std::isfinite(upper)) {
    chart.lines.push_back({report::Direction::horizontal, upper, "wall"});
    const double margin = 0.1 * (upper - lower);
    chart.y.range = report::Range{lower - margin, upper + margin};
  }
  chart.height = 240;
  return chart;
}

}  // namespace ricochet::studies::reproduction
