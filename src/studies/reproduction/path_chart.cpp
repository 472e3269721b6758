#include "src/studies/reproduction/path_chart.h"

#include <cmath>
#include <numbers>

namespace ricochet::studies::reproduction {
namespace {

bool in_turns(const carrier_track::Scene& scene) {
  return std::holds_alternative<carrier_track::Revolutions>(scene.window) && scene.profile.empty();
}

}  // namespace

std::vector<report::Sample> path_samples(const carrier_track::Scene& scene,
                                         const carrier_track::Recording& recording) {
  const double unit = in_turns(scene) ? 2 * std::numbers::pi / scene.omega : 1.0;
  std::vector<report::Sample> samples;
  double last = -1;
  for (const carrier_track::Sample& s : recording.path) {
    if (s.time <= last) continue;  // an impact has two samples, before and after
    last = s.time;
    samples.push_back({s.time / unit, s.position / millimetre});
  }
  return samples;
}

report::Chart path_chart(const carrier_track::Scene& scene,
                         const carrier_track::Recording& recording, std::string name,
                         std::string title) {
  report::Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = in_turns(scene) ? "driver plate [turns]" : "time [s]";
  chart.y.label = "x [mm]";
  chart.series = {{"", report::Mark::line, path_samples(scene, recording)}};
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
