#include "problems/carrier_track/advice/regime_map_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "src/report/simplified.h"

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

}  // namespace ricochet::studies::advice
