#include "src/studies/machine/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"

namespace ricochet::studies {

using namespace carrier_track;

namespace {

constexpr double zoom_samples = 1500;  // per path

/// The abscissa of a path: turns of the driver plate if the scene's window is in turns, else time.
struct PathAxis {
  std::string label;
  double unit;  ///< [s]
};

PathAxis path_axis(const Scene& scene) {
  if (std::holds_alternative<Revolutions>(scene.window) && scene.profile.empty()) {
    return {"driver plate [turns]", 2 * std::numbers::pi / scene.omega};
  }
  return {"time [s]", 1};
}

}  // namespace

std::string counted_label(const Scene& scene) {
  return scene.rule == CountRule::impacts ? "impact that counts" : "maximum that counts";
}

report::Chart path_chart(const Scene& scene, const Recording& recording, std::string name,
                         std::string title) {
  const auto [label, unit] = path_axis(scene);
  report::Chart chart{.name = std::move(name),
                      .title = std::move(title),
                      .x = {label},
                      .y = {"x [mm]"},
                      .series = {{"path"}, {counted_label(scene), report::Mark::points}},
                      .height = 240};
  double last = -1;
  for (const carrier_track::Sample& s : recording.path) {
    if (s.time <= last) continue;  // an impact has two samples, before and after
    last = s.time;
    chart.series[0].samples.push_back({s.time / unit, s.position / millimetre});
  }
  for (const Feature& feature : counted_features(scene, recording))
    chart.series[1].samples.push_back({feature.time / unit, feature.position / millimetre});
  const double lower = scene.wall_lower / millimetre;
  const double upper = scene.wall_upper / millimetre;
  chart.lines = {{report::Direction::horizontal, lower, "wall"}};
  if (std::isfinite(upper)) {
    chart.lines.push_back({report::Direction::horizontal, upper, "wall"});
    const double margin = 0.1 * (upper - lower);
    chart.y.range = report::Range{lower - margin, upper + margin};
  }
  return chart;
}

std::optional<report::Chart> zoom_chart(const Scene& scene, const Recording& recording) {
  const auto stretch = busiest_stretch(scene, recording);
  if (!stretch) return std::nullopt;
  const double unit = path_axis(scene).unit;
  const double share = (stretch->to - stretch->from) / duration_of(scene);
  const Recording fine = record(scene, 0, static_cast<std::size_t>(zoom_samples / share));
  report::Chart chart = path_chart(scene, fine, "zoom", "Where most of what counts happens");
  const report::Range at{stretch->from / unit, stretch->to / unit};
  for (report::Series& series : chart.series) {
    std::erase_if(series.samples, [&](const report::Sample& sample) {
      return sample.position < at.lower || sample.position > at.upper;
    });
  }
  const auto& path = chart.series[0].samples;
  if (path.empty()) return std::nullopt;
  const auto [lowest, highest] = std::ranges::minmax_element(path, {}, &report::Sample::value);
  const double room = 0.1 * (*highest->value - *lowest->value);
  if (!(room > 0)) return std::nullopt;
  chart.x.range = at;
  chart.y.range = report::Range{*lowest->value - room, *highest->value + room};
  const auto is_outside = [&](double x) {
    return x < chart.y.range->lower || x > chart.y.range->upper;
  };
  std::erase_if(chart.series[1].samples,
                [&](const report::Sample& mark) { return is_outside(*mark.value); });
  std::erase_if(chart.lines,
                [&](const report::ReferenceLine& wall) { return is_outside(wall.position); });
  return chart;
}

}  // namespace ricochet::studies

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;

constexpr std::size_t most_colours = 8;
constexpr double least_share = 2e-3;  // of the cells, for a count to have a colour of its own

/// Counts with one colour.
struct Band {
  double least, most;  ///< collisions a turn
};

/// The colours of a map: those counts that are to be seen, the highest ones in two ranges. A count
/// that is not to be seen takes the colour of the next higher one.
std::vector<Band> bands_of(const RegimeMap& map) {
  std::map<double, double> counts;
  for (const MapColumn& column : map.columns)
    for (const auto& cell : column.cells)
      if (cell) ++counts[*cell];
  const auto all = static_cast<double>(map.columns.size() * map.heights.size());
  std::vector<Band> bands;
  for (const auto& [collisions, cells] : counts) {
    const bool last = collisions == counts.rbegin()->first;
    if (cells >= least_share * all || collisions == 0 || (last && bands.empty())) {
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

/// Where the cells of a map that `belongs` takes are: cells above each other are one, and go on in
/// the next column if some of them do.
template <class Belongs>
std::vector<std::vector<report::Area::Edge>> parts_of(const RegimeMap& map, const MapUnits& units,
                                                      const Belongs& belongs) {
  const auto& [over, values, against] = map.options;
  const double wide = (over.to - over.from) / (values - 1);
  const double high = (against.to - against.from) / static_cast<double>(map.heights.size());
  std::vector<std::vector<report::Area::Edge>> done, open;
  double right = over.from / units.over.size;
  for (const MapColumn& column : map.columns) {
    const double left = right;
    right = std::min(over.to, column.value + wide / 2) / units.over.size;
    std::vector<std::vector<report::Area::Edge>> here;
    const std::size_t cells = column.cells.size();
    for (std::size_t from = 0, to = 0; from < cells; from = to = to + 1) {
      while (to < cells && belongs(column.cells[to])) ++to;
      if (to == from) continue;
      const report::Range between{(map.heights[from] - high / 2) / units.against.size,
                                  (map.heights[to - 1] + high / 2) / units.against.size};
      const auto before = std::ranges::find_if(open, [&](const auto& part) {
        const report::Range& last = part.back().between;
        return last.lower < between.upper && between.lower < last.upper;
      });
      if (before == open.end()) {
        here.push_back({{left, between}, {right, between}});
        continue;
      }
      here.push_back(std::move(*before));
      open.erase(before);
      const report::Range last = here.back().back().between;
      if (last.lower == between.lower && last.upper == between.upper) {
        here.back().back().position = right;
      } else {
        here.back().insert(here.back().end(), {{left, between}, {right, between}});
      }
    }
    done.insert(done.end(), open.begin(), open.end());
    open = std::move(here);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

std::vector<report::Area> areas_of(const RegimeMap& map, const MapUnits& units) {
  std::vector<report::Area> areas;
  double below = -1;
  const std::vector<Band> bands = bands_of(map);
  for (const Band& band : bands) {
    const std::string numbers = band.least == band.most
                                    ? fmt::format("{:.4g}", band.most)
                                    : fmt::format("{:.4g} to {:.4g}", band.least, band.most);
    const bool silent = band.most == 0;
    const double share = static_cast<double>(areas.size()) /
                         std::max<double>(1, static_cast<double>(bands.size()) - 1);
    areas.push_back(
        {silent ? "silent: no impact is fast enough to count"
                : fmt::format("{}{} collision{} a turn", map.disturbed ? "at most " : "", numbers,
                              band.most == 1 ? "" : "s"),
         1 - 0.95 * share,
         parts_of(map, units,
                  [&](const auto& cell) { return cell && *cell > below && *cell <= band.most; }),
         silent ? "silent" : numbers});
    below = band.most;
  }
  report::Area irregular{"the motion does not repeat", std::nullopt,
                         parts_of(map, units, [](const auto& cell) { return !cell; })};
  if (!irregular.parts.empty()) areas.push_back(std::move(irregular));
  return areas;
}

/// The borders of the machine, with gaps between.
report::Series borders_of(const RegimeMap& map, double size) {
  report::Series series{"border of the machine", report::Mark::line, {}};
  series.dark = true;
  for (const MapCurve& curve : map.curves) {
    if (curve.points.size() < 2) continue;  // a dot is no line
    if (!series.samples.empty())
      series.samples.push_back({series.samples.back().position, std::nullopt});
    for (const MapPoint& point : curve.points)
      series.samples.push_back({point.constant / size, point.omega});
  }
  return series;
}

report::Axis axis_of(const MapAxis& axis, const ShownUnit& unit) {
  const std::string name = axis.key == "omega" ? "speed of the driver plate" : axis.key;
  return {.label = unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name),
          .range = report::Range{axis.from / unit.size, axis.to / unit.size}};
}

}  // namespace

report::Chart regime_map_chart(const RegimeMap& map, std::string title, const MapUnits& units,
                               const MapMarks& marks) {
  report::Chart chart{.name = "regime-map",
                      .title = std::move(title),
                      .x = axis_of(map.options.over, units.over),
                      .y = axis_of(map.options.against, units.against),
                      .areas = areas_of(map, units),
                      .width = 960,
                      .height = 520};
  report::Series points{"the paper's threshold", report::Mark::points, {}};
  points.dark = true;
  for (const MapMarks::Point& point : marks.thresholds) {
    points.samples.push_back(
        {point.constant / units.over.size, point.omega, std::nullopt, point.name});
  }
  if (!points.samples.empty()) chart.series.push_back(std::move(points));
  if (map.followed) chart.series.push_back(borders_of(map, units.over.size));
  for (const MapMarks::Value& machine : marks.machines) {
    chart.lines.push_back(
        {report::Direction::vertical, machine.constant / units.over.size, machine.label});
  }
  return chart;
}

namespace {

/// Sampled where the count changes.
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

}  // namespace

report::Chart staircase_chart(const QuietSpeed& answer, std::string title,
                              const std::vector<MarkedSpeed>& marked) {
  const double fastest = answer.options.fastest;
  report::Chart chart{
      .name = "staircase",
      .title = std::move(title),
      .x = {.label = "speed [rad/s]", .range = report::Range{0, fastest}},
      .y = {.label = answer.is_of_the_long_run() ? "collisions a turn, in the long run"
                                                 : "collisions in the window"},
      .series = {{"collisions", report::Mark::steps, staircase_samples(answer)}},
      .width = 960,
      .height = 400};
  double most = 0;
  for (const report::Sample& sample : chart.series.front().samples)
    most = std::max(most, *sample.value);
  chart.y.range = report::Range{0, 1 + 1.1 * most};
  for (const auto& [omega, label] : marked) {
    if (omega && *omega <= fastest)
      chart.lines.push_back({report::Direction::vertical, *omega, label});
  }
  for (const Step& step : answer.staircase.steps) {
    if (step.omega <= fastest)
      chart.lines.push_back({report::Direction::vertical, step.omega, "step"});
  }
  return chart;
}

}  // namespace ricochet::studies::advice
