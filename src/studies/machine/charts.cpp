#include "src/studies/machine/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "src/report/painted.h"

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

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;

constexpr std::size_t most_colours = 8;
constexpr double least_share =
    2e-3;  // share of the map from which on a count has a colour of its own

constexpr int chart_width = 960, chart_height = 520;  // pixels
constexpr double unseen = 0.15;                       // pixels

/// Counts with one colour.
struct Band {
  double least, most;  ///< collisions a turn
};

/// The area of a region within the range of speeds.
double area_of(const MapRegion& region, const RegimeOptions& speeds) {
  double area = 0;
  for (std::size_t i = 0; i + 1 < region.edges.size(); ++i) {
    const auto height = [&](const MapRegion::Edge& edge) {
      return std::max(0.0, std::min(edge.upper, speeds.to) - std::max(edge.lower, speeds.from));
    };
    const MapRegion::Edge& a = region.edges[i];
    const MapRegion::Edge& b = region.edges[i + 1];
    area += (b.constant - a.constant) * (height(a) + height(b)) / 2;
  }
  return area;
}

/// The colours of a map: those counts that are to be seen, the highest ones in two ranges. A count
/// that is not to be seen takes the colour of the next higher one.
std::vector<Band> bands_of(const RegimeMap& map) {
  std::map<double, double> areas;
  double all = 0;
  for (const MapRegion& region : map.regions) {
    const double area = area_of(region, map.options.speeds);
    all += area;
    if (region.certain) areas[region.collisions] += area;
  }
  std::vector<Band> bands;
  for (const auto& [collisions, area] : areas) {
    const bool last = collisions == areas.rbegin()->first;
    if (area >= least_share * all || collisions == 0 || (last && bands.empty())) {
      bands.push_back({collisions, collisions});
    } else if (last) {
      bands.back().most = collisions;
    }
  }
  if (bands.size() > most_colours) {
    const std::size_t alone = most_colours - 2, half = (alone + bands.size()) / 2;
    bands[alone].most = bands[half - 1].most;
    bands[alone + 1] = {bands[half].least, bands.back().most};
    bands.resize(most_colours);
  }
  return bands;
}

std::string numbers_of(const Band& band) {
  return band.least == band.most ? fmt::format("{:.4g}", band.most)
                                 : fmt::format("{:.4g} to {:.4g}", band.least, band.most);
}

/// The edges of a region that suffice to draw it to a fraction of a pixel.
std::vector<report::Area::Edge> drawn_edges(const MapRegion& region, const RegimeMap& map,
                                            double size) {
  const RegimeMapOptions& options = map.options;
  std::vector<report::Pixel> lower, upper;
  for (const MapRegion::Edge& edge : region.edges) {
    const double x = chart_width * (edge.constant - options.from) / (options.to - options.from);
    const double scale = chart_height / options.speeds.to;
    lower.push_back({x, scale * edge.lower});
    upper.push_back({x, scale * edge.upper});
  }
  std::set<std::size_t> kept;
  for (const auto& line : {lower, upper}) {
    for (const std::size_t i : report::needed_corners(line, unseen)) kept.insert(i);
  }
  std::vector<report::Area::Edge> edges;
  for (const std::size_t i : kept) {
    const MapRegion::Edge& edge = region.edges[i];
    edges.push_back({edge.constant / size, {edge.lower, edge.upper}});
  }
  return edges;
}

report::Area area_of(const RegimeMap& map, const std::vector<Band>& bands, std::size_t which,
                     double size) {
  const Band& band = bands[which];
  const double below = which == 0 ? -1 : bands[which - 1].most;
  report::Area area;
  area.name = band.most == 0 ? "silent" : numbers_of(band);
  area.label = band.most == 0
                   ? "silent: no impact is fast enough to count"
                   : fmt::format("{}{} collision{} a turn", map.followed ? "" : "at most ",
                                 numbers_of(band), band.most == 1 ? "" : "s");
  const double steps = std::max<double>(1, static_cast<double>(bands.size()) - 1);
  area.shade = 1 - 0.95 * static_cast<double>(which) / steps;
  for (const MapRegion& region : map.regions) {
    if (!region.certain || region.collisions <= below || region.collisions > band.most) continue;
    area.parts.push_back(drawn_edges(region, map, size));
  }
  return area;
}

std::optional<report::Area> irregular_area(const RegimeMap& map, double size) {
  report::Area area{"the motion does not repeat", std::nullopt, {}, {}};
  for (const MapRegion& region : map.regions) {
    if (region.certain) continue;
    area.parts.push_back(drawn_edges(region, map, size));
  }
  return area.parts.empty() ? std::nullopt : std::optional(area);
}

/// One line for all borders that `belongs` takes, with gaps between.
template <class Belongs>
report::Series borders_of(const RegimeMap& map, std::string label, double size,
                          const Belongs& belongs) {
  report::Series series{std::move(label), report::Mark::line, {}};
  series.dark = true;
  for (const MapCurve& curve : map.curves) {
    if (!belongs(curve) || curve.points.size() < 2) continue;  // a dot is no line
    if (!series.samples.empty()) {
      series.samples.push_back({series.samples.back().position, std::nullopt});
    }
    const double fastest = map.options.speeds.to;
    // To the end of the range of speeds, along the slope there.
    const auto lead_out = [&](const MapPoint& point, CurveEnd end,
                              std::vector<report::Sample>& line) {
      if (end != CurveEnd::speeds || !point.slope || *point.slope == 0) return;
      const double constant = point.constant + (fastest - point.omega) / *point.slope;
      line.push_back({constant / size, fastest});
    };
    std::vector<report::Sample> line;
    lead_out(curve.points.front(), curve.begins, line);
    for (const MapPoint& point : curve.points) line.push_back({point.constant / size, point.omega});
    lead_out(curve.points.back(), curve.ends, line);
    const double across = (map.options.to - map.options.from) / size / chart_width;
    const std::vector<report::Sample> drawn =
        report::simplified(line, unseen * across, unseen * fastest / chart_height);
    series.samples.insert(series.samples.end(), drawn.begin(), drawn.end());
  }
  return series;
}

}  // namespace

report::Chart regime_map_chart(const RegimeMap& map, std::string title, const ShownUnit& unit,
                               const MapMarks& marks) {
  report::Chart chart;
  chart.name = "regime-map";
  chart.title = std::move(title);
  chart.width = chart_width;
  chart.height = chart_height;
  const std::string& constant = map.options.constant;
  chart.x = {.label = unit.name.empty() ? constant : fmt::format("{} [{}]", constant, unit.name),
             .range = report::Range{map.options.from / unit.size, map.options.to / unit.size}};
  chart.y = {.label = "speed of the driver plate [rad/s]",
             .range = report::Range{0, map.options.speeds.to}};
  const std::vector<Band> bands = bands_of(map);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    chart.areas.push_back(area_of(map, bands, i, unit.size));
  }
  if (const auto irregular = irregular_area(map, unit.size)) chart.areas.push_back(*irregular);
  const auto is_limit = [](const MapCurve& curve) {
    return curve.kind == RegimeEnd::counting_limit;
  };
  const auto is_release = [](const MapCurve& curve) { return curve.kind == RegimeEnd::release; };
  // In this order the threshold is a filled dot, and the first line a solid one.
  report::Series points{"the paper's threshold", report::Mark::points, {}};
  points.dark = true;
  for (const MapMarks::Point& point : marks.thresholds) {
    points.samples.push_back({point.constant / unit.size, point.omega, std::nullopt, point.name});
  }
  chart.series = {
      points, borders_of(map, "border: the carrier starts to move", unit.size, is_release),
      borders_of(map, "border: the motion changes in another way", unit.size,
                 [&](const MapCurve& curve) { return !is_limit(curve) && !is_release(curve); }),
      borders_of(map, "border: another impact counts", unit.size, is_limit)};
  for (report::Series& series : chart.series) {
    if (series.samples.empty()) series.label = "";
  }
  for (const MapMarks::Value& machine : marks.machines) {
    chart.lines.push_back(
        {report::Direction::vertical, machine.constant / unit.size, machine.label});
  }
  return chart;
}

std::vector<report::Sample> staircase_samples(const QuietSpeed& answer) {
  std::vector<report::Sample> samples;
  if (answer.is_of_the_long_run()) {
    for (const Regime& regime : answer.regimes) {
      samples.push_back({regime.from, regime.collisions_per_turn});
    }
    samples.push_back({answer.regimes.back().to, answer.regimes.back().collisions_per_turn});
    return samples;
  }
  const LogarithmicScan& scan = answer.scan;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size() || scan.omega(k + 1) > answer.options.fastest;
    if (k == 0 || last || scan.counts[k] != scan.counts[k - 1]) {
      samples.push_back({scan.omega(k), scan.counts[k]});
    }
    if (last) break;
  }
  return samples;
}

report::Chart staircase_chart(const QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked) {
  report::Chart chart;
  chart.name = "staircase";
  chart.title = std::move(title);
  chart.width = 960;
  chart.height = 400;
  const double fastest = answer.options.fastest;
  chart.series = {{"collisions", report::Mark::steps, staircase_samples(answer)}};
  double most = 0;
  for (const report::Sample& sample : chart.series.front().samples) {
    most = std::max(most, *sample.value);
  }
  chart.x = {.label = "speed [rad/s]", .range = report::Range{0, fastest}};
  chart.y = {.label = answer.is_of_the_long_run() ? "collisions a turn, in the long run"
                                                  : "collisions in the window",
             .range = report::Range{0, 1 + 1.1 * most}};
  const auto mark = [&](const std::optional<double>& omega, const std::string& label) {
    if (omega && *omega <= fastest) {
      chart.lines.push_back({report::Direction::vertical, *omega, label});
    }
  };
  for (const auto& [omega, label] : marked) mark(omega, label);
  for (const Step& step : answer.staircase.steps) mark(step.omega, "step");
  return chart;
}

}  // namespace ricochet::studies::advice
