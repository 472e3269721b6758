#include "problems/carrier_track/advice/path_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/window.h"
#include "ricochet/recording.h"

namespace ricochet::studies {

using namespace carrier_track;

namespace {

constexpr double zoom_samples = 1500;  // per path

}  // namespace

PathAxis path_axis(const Scene& scene) {
  if (std::holds_alternative<Revolutions>(scene.window) && scene.profile.empty()) {
    return {"driver plate [turns]", 2 * std::numbers::pi / scene.omega};
  }
  return {"time [s]", 1};
}

std::vector<report::Sample> path_samples(const Scene& scene, const Recording& recording) {
  const double unit = path_axis(scene).unit;
  std::vector<report::Sample> samples;
  double last = -1;
  for (const carrier_track::Sample& s : recording.path) {
    if (s.time <= last) continue;  // an impact has two samples, before and after
    last = s.time;
    samples.push_back({s.time / unit, s.position / millimetre});
  }
  return samples;
}

std::vector<report::Sample> counted_samples(const Scene& scene, const Recording& recording) {
  const double unit = path_axis(scene).unit;
  std::vector<report::Sample> samples;
  for (const auto& perturbation : counted_features(scene, recording)) {
    samples.push_back({perturbation.time / unit, perturbation.position / millimetre});
  }
  return samples;
}

std::string counted_label(const Scene& scene) {
  return scene.rule == CountRule::impacts ? "impact that counts" : "maximum that counts";
}

std::optional<PathZoom> path_zoom(const Scene& scene, const Recording& recording) {
  const auto stretch = busiest_stretch(scene, recording);
  if (!stretch) return std::nullopt;
  const double unit = path_axis(scene).unit;
  const double share = (stretch->to - stretch->from) / duration_of(scene);
  const Recording fine = record(scene, 0, static_cast<std::size_t>(zoom_samples / share));
  PathZoom zoom{{stretch->from / unit, stretch->to / unit}, {0, 0}, path_samples(scene, fine)};
  std::erase_if(zoom.path, [&](const report::Sample& sample) {
    return sample.position < zoom.at.lower || sample.position > zoom.at.upper;
  });
  if (zoom.path.empty()) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(
      zoom.path.begin(), zoom.path.end(),
      [](const report::Sample& a, const report::Sample& b) { return *a.value < *b.value; });
  const double room = 0.1 * (*highest->value - *lowest->value);
  zoom.x = {*lowest->value - room, *highest->value + room};
  return room > 0 ? std::optional(std::move(zoom)) : std::nullopt;
}

report::Chart path_chart(const Scene& scene, const Recording& recording, std::string name,
                         std::string title) {
  report::Chart chart;
  chart.name = std::move(name);
  chart.title = std::move(title);
  chart.x.label = path_axis(scene).label;
  chart.y.label = "x [mm]";
  chart.series = {{"path", report::Mark::line, path_samples(scene, recording)},
                  {counted_label(scene), report::Mark::points, counted_samples(scene, recording)}};
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

report::Chart zoom_chart(const Scene& scene, const Recording& recording, const PathZoom& zoom,
                         std::string name) {
  report::Chart chart =
      path_chart(scene, recording, std::move(name), "Where most of what counts happens");
  chart.x.range = zoom.at;
  chart.y.range = zoom.x;
  chart.series.front().samples = zoom.path;
  const auto is_outside = [](double value, const report::Range& range) {
    return value < range.lower || value > range.upper;
  };
  std::erase_if(chart.series.back().samples, [&](const report::Sample& mark) {
    return is_outside(mark.position, zoom.at) || is_outside(*mark.value, zoom.x);
  });
  std::erase_if(chart.lines, [&](const report::ReferenceLine& wall) {
    return is_outside(wall.position, zoom.x);
  });
  return chart;
}

}  // namespace ricochet::studies
