#include "problems/carrier_track/regimes/regime_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/map_strip.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr int finest = 16;  // parts of the distance of two values, where regimes are refined
constexpr int at_most = 4;  // times as many columns as values
constexpr int most_values = 10'000;

Scene machine_at(const Scene& machine, const std::string& constant, double value) {
  Scene scene = machine;
  set_constant(scene, constant, value);
  scene.start_position = std::clamp(scene.start_position, scene.wall_lower, scene.wall_upper);
  return scene;
}

void check_options(const Scene& machine, const RegimeMapOptions& options) {
  constant_named(machine, options.constant);
  const std::string origin = fmt::format("{} {} to {}", options.constant, options.from, options.to);
  if (!(options.from < options.to && std::isfinite(options.from) && std::isfinite(options.to))) {
    throw InputError(origin + ": must rise");
  }
  if (options.values && !(*options.values >= 2 && *options.values <= most_values)) {
    throw InputError(fmt::format("values: {} is not within 2..{}", *options.values, most_values));
  }
  check_regimes_exist(machine, "scene");
  for (const double end : {options.from, options.to}) {
    Scene scene = machine;
    set_constant(scene, options.constant, end);
    const bool has_room = scene.wall_upper > scene.wall_lower;
    if (has_room) scene = machine_at(machine, options.constant, end);
    check(scene, origin);
  }
}

/// Columns and strips by the constants at their left ends.
class MapMaker {
 public:
  MapMaker(const Scene& machine, const RegimeMapOptions& options)
      : machine_(machine), options_(options) {
    map_.options = options;
    map_.own = constant_named(machine, options.constant);
    map_.followed = true;
    for (const double value : {options.from, map_.own, options.to}) {
      Scene scene = machine;
      set_constant(scene, options.constant, value);
      if (is_disturbed(scene)) map_.followed = false;
    }
    values_ = options.values.value_or(map_.followed ? usual_values : few_values);
  }

  RegimeMap map() {
    solve(first_values());
    for (int parts = 2; map_.followed && parts <= finest; parts *= 2) {
      const std::vector<double> refined = values_between();
      const auto limit = static_cast<std::size_t>(at_most * values_);
      if (refined.empty() || columns_.size() + refined.size() > limit) break;
      solve(refined);
    }
    for (auto& [constant, column] : columns_) map_.columns.push_back(column);
    join_curves();
    join_regions();
    return std::move(map_);
  }

 private:
  struct Strip {
    double to;
    std::vector<StripLink> links;
    StripRegions regions;
  };

  std::vector<double> first_values() const {
    std::vector<double> values;
    for (int k = 0; k < values_; ++k) {
      const double share = k / (values_ - 1.0);
      values.push_back(k + 1 == values_ ? options_.to
                                        : options_.from + share * (options_.to - options_.from));
    }
    if (map_.own > options_.from && map_.own < options_.to) {
      // In place of a value that is the same but for rounding.
      std::erase_if(values, [&](double value) {
        return std::abs(value - map_.own) < 1e-9 * (options_.to - options_.from);
      });
      values.push_back(map_.own);
    }
    return values;
  }

  /// Halves the strips whose regions change on the way.
  std::vector<double> values_between() const {
    std::vector<double> values;
    for (const auto& [from, strip] : strips_) {
      const bool sharp = std::ranges::all_of(columns_.at(from).regimes,
                                             [](const Regime& regime) { return regime.certain; });
      if (sharp && !strip.regions.whole) values.push_back(0.5 * (from + strip.to));
    }
    return values;
  }

  void solve(const std::vector<double>& values) {
    std::vector<MapColumn> solved(values.size());
    in_parallel("regimes", values.size(), [&](std::size_t i) {
      const Scene scene = machine_at(machine_, options_.constant, values[i]);
      solved[i] = {values[i], regimes_of(scene, options_.speeds)};
      if (solved[i].regimes.back().ends_by == RegimeEnd::time_limit) throw TimeLimitReached();
    });
    for (MapColumn& column : solved) columns_[column.constant] = std::move(column);
    std::vector<std::pair<const MapColumn*, const MapColumn*>> open;
    for (auto left = columns_.begin(), right = std::next(left); right != columns_.end();
         ++left, ++right) {
      const auto known = strips_.find(left->first);
      if (known != strips_.end() && known->second.to == right->first) continue;
      open.emplace_back(&left->second, &right->second);
    }
    std::vector<Strip> strips(open.size());
    in_parallel("borders", open.size(), [&](std::size_t i) {
      const auto& [left, right] = open[i];
      strips[i] = {right->constant, strip_links(*left, *right, options_, map_.followed), {}};
      strips[i].regions = strip_regions(*left, *right, strips[i].links, options_);
    });
    for (std::size_t i = 0; i < open.size(); ++i) {
      strips_[open[i].first->constant] = std::move(strips[i]);
    }
  }

  void join_curves() {
    std::map<std::size_t, std::size_t> open;  // the curve of each border of the column
    bool first = true;
    for (const auto& [from, strip] : strips_) {
      const MapColumn& left = columns_.at(from);
      const MapColumn& right = columns_.at(strip.to);
      std::map<std::size_t, std::size_t> next;
      for (const StripLink& link : strip.links) {
        const auto known = link.left ? open.find(*link.left) : open.end();
        const std::size_t curve =
            known != open.end() ? known->second : begun(link, left, right, first);
        append(curve, link, left.constant);
        if (link.right) next[*link.right] = curve;
        if (!link.right) map_.curves[curve].ends = link.end;
      }
      open = std::move(next);
      first = false;
    }
    for (MapCurve& curve : map_.curves) keep_within(curve);
    std::erase_if(map_.curves, [](const MapCurve& curve) { return curve.points.empty(); });
    std::ranges::stable_sort(map_.curves, {}, [](const MapCurve& curve) {
      return std::pair(curve.points.front().omega, curve.points.front().constant);
    });
  }

  std::size_t begun(const StripLink& link, const MapColumn& left, const MapColumn& right,
                    bool first) {
    const MapColumn& column = link.left ? left : right;
    const std::size_t border = link.left ? *link.left : *link.right;
    const Regime& slower = column.regimes[border];
    const Regime& faster = column.regimes[border + 1];
    map_.curves.push_back({slower.ends_by,
                           slower.most_per_turn,
                           faster.most_per_turn,
                           {},
                           link.left && first ? CurveEnd::range : link.end,
                           CurveEnd::range,
                           {}});
    // A curve that begins at a column is one that did not lead there from the column before.
    if (link.left && !first) map_.curves.back().begins = CurveEnd::other_motion;
    return map_.curves.size() - 1;
  }

  void append(std::size_t curve, const StripLink& link, double left) {
    std::vector<MapPoint>& points = map_.curves[curve].points;
    for (const MapPoint& point : link.points) {
      if (!points.empty() && point.constant <= points.back().constant) continue;
      points.push_back(point);
    }
    if (left == map_.own && link.left) map_.curves[curve].own = link.points.front().omega;
    if (link.right && link.points.back().constant == map_.own) {
      map_.curves[curve].own = link.points.back().omega;
    }
  }

  /// Drops the points beyond the range of speeds.
  void keep_within(MapCurve& curve) const {
    const auto outside = [&](const MapPoint& point) {
      return point.omega > options_.speeds.to || point.omega < options_.speeds.from;
    };
    if (curve.points.empty()) return;
    if (outside(curve.points.front())) curve.begins = CurveEnd::speeds;
    if (outside(curve.points.back())) curve.ends = CurveEnd::speeds;
    std::erase_if(curve.points, outside);
  }

  void join_regions() {
    std::vector<MapRegion> open;
    for (const auto& [from, strip] : strips_) {
      for (const MapRegion& region : strip.regions.regions) {
        const MapRegion::Edge& begin = region.edges.front();
        const auto before = std::ranges::find_if(open, [&](const MapRegion& other) {
          const MapRegion::Edge& end = other.edges.back();
          const auto meets = [](double a, double b) { return std::abs(a - b) <= 1e-6 * (a + b); };
          return end.constant == begin.constant && other.certain == region.certain &&
                 (other.collisions == region.collisions || !region.certain) &&
                 meets(end.lower, begin.lower) && meets(end.upper, begin.upper);
        });
        if (before == open.end()) {
          open.push_back(region);
        } else {
          before->edges.insert(before->edges.end(), region.edges.begin() + 1, region.edges.end());
        }
      }
      // Regions that end before this strip's end are complete.
      const auto ended = std::stable_partition(open.begin(), open.end(),
                                               [end = strip.to](const MapRegion& region) {
                                                 return region.edges.back().constant == end;
                                               });
      map_.regions.insert(map_.regions.end(), ended, open.end());
      open.erase(ended, open.end());
    }
    map_.regions.insert(map_.regions.end(), open.begin(), open.end());
  }

  const Scene& machine_;
  const RegimeMapOptions& options_;
  int values_;
  RegimeMap map_;
  std::map<double, MapColumn> columns_;
  std::map<double, Strip> strips_;
};

}  // namespace

std::optional<double> RegimeMap::collisions_at(double constant, double omega) const {
  if (!(omega >= options.speeds.from && omega <= options.speeds.to)) return std::nullopt;
  for (const MapRegion& region : regions) {
    const auto& edges = region.edges;
    if (constant < edges.front().constant || constant > edges.back().constant) continue;
    const auto after = std::ranges::find_if(
        edges, [&](const MapRegion::Edge& edge) { return edge.constant >= constant; });
    const MapRegion::Edge& b = *after;
    const MapRegion::Edge& a = after == edges.begin() ? b : *std::prev(after);
    const double share =
        b.constant > a.constant ? (constant - a.constant) / (b.constant - a.constant) : 0;
    const double lower = a.lower + share * (b.lower - a.lower);
    const double upper = a.upper + share * (b.upper - a.upper);
    if (omega >= lower && omega < upper) return region.collisions;
  }
  return std::nullopt;
}

RegimeMap regime_map(const Scene& machine, const RegimeMapOptions& options) {
  check_options(machine, options);
  return MapMaker(machine, options).map();
}

}  // namespace ricochet::carrier_track::inline regimes
