#include "problems/carrier_track/regimes/regime_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr int most_values = 10'000;
constexpr int parts = 4;  // points of a curve for each step of the constant
constexpr std::size_t most_levels = 8;
constexpr double slow_rebounds = 1e-3;  // of the counting limit: slower ones are summed

// Turns of a machine without disturbance are flown until they repeat.
constexpr int first_turns = 8, most_turns = 512;
constexpr double same_turn = 1e-6;  // relative, of the sum of the speeds
constexpr int settling_turns = 4;   // under a disturbance

Scene with(Scene scene, const std::string& key, double value) {
  if (key == "omega") {
    scene = at_speed(scene, value);
  } else {
    set_constant(scene, key, value);
  }
  scene.start_position =
      std::max(std::min(scene.start_position, scene.wall_upper), scene.wall_lower);
  return scene;
}

/// The turns of a flight.
struct FlownTurns : Observer {
  static constexpr bool hears_impacts_alone = true;

  struct Turn {
    int collisions = 0;
    double speeds = 0;  ///< [m/s], the sum of all impacts
  };

  double counting_limit = 0;
  double duration = 0;  ///< [s], of a turn
  std::vector<Turn> turns;

  void impact(double time, Wall /*wall*/, double speed) {
    Turn& turn = turns[std::min(static_cast<std::size_t>(time / duration), turns.size() - 1)];
    turn.speeds += speed;
    if (is_counted(speed, counting_limit)) ++turn.collisions;
  }

  /// The mean of a period, if the second half of the turns repeats turns before; else nothing.
  std::optional<double> per_turn() const {
    const auto half = static_cast<std::ptrdiff_t>(turns.size() / 2);
    const auto is_same = [](const Turn& a, const Turn& b) {
      return a.collisions == b.collisions &&
             std::abs(a.speeds - b.speeds) <= same_turn * std::max(a.speeds, b.speeds);
    };
    for (std::ptrdiff_t period = 1; period <= half; ++period) {
      if (!std::equal(turns.end() - half, turns.end(), turns.end() - half - period, is_same))
        continue;
      int sum = 0;
      for (auto turn = turns.end() - period; turn != turns.end(); ++turn) sum += turn->collisions;
      return static_cast<double>(sum) / static_cast<double>(period);
    }
    return std::nullopt;
  }
};

/// Flies some turns of each scene, side by side, and lets the scene start where they ended.
std::vector<FlownTurns> flown(std::span<Scene*> scenes, int turns) {
  std::vector<FlownTurns> counts(scenes.size());
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    scenes[k]->window = Revolutions{static_cast<double>(turns)};
    counts[k].counting_limit = scenes[k]->counting_limit;
    counts[k].duration = 2 * std::numbers::pi / scenes[k]->omega;
    counts[k].turns.resize(static_cast<std::size_t>(turns));
  }
  const auto outcomes = run_in_lanes(
      scenes.size(),
      [&](std::size_t k) {
        return ImpactModel<double>(*scenes[k], slow_rebounds * scenes[k]->counting_limit);
      },
      [&](std::size_t k) -> FlownTurns& { return counts[k]; });
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    Scene& scene = *scenes[k];
    const End<double>& end = outcomes[k].end;
    scene.start_position = end.position;
    scene.start_velocity = end.velocity;
    scene.disturbance_phase = std::remainder(
        scene.disturbance_phase + scene.disturbance_frequency * end.time, 2 * std::numbers::pi);
  }
  return counts;
}

using Cell = std::optional<double>;

/// The cells of some machines without disturbance, which start where they end.
std::vector<Cell> settled(std::span<Scene> machines) {
  std::vector<Cell> cells(machines.size());
  for (int turns = first_turns; turns <= most_turns; turns *= 2) {
    std::vector<std::size_t> open;
    std::vector<Scene*> scenes;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (cells[k]) continue;
      open.push_back(k);
      scenes.push_back(&machines[k]);
    }
    const std::vector<FlownTurns> counts = flown(scenes, turns);
    for (std::size_t i = 0; i < open.size(); ++i) cells[open[i]] = counts[i].per_turn();
  }
  return cells;
}

/// The cell of one machine at all phases of its disturbance.
Cell loudest(std::span<Scene> at_phases) {
  std::vector<Scene*> scenes;
  for (Scene& scene : at_phases) scenes.push_back(&scene);
  int most = 0;
  for (const FlownTurns& counts : flown(scenes, settling_turns + map_turns)) {
    for (std::size_t k = settling_turns; k < counts.turns.size(); ++k)
      most = std::max(most, counts.turns[k].collisions);
  }
  return most;
}

/// Fills columns that are flown side by side, from the lowest height up.
void fill(std::span<MapColumn> columns, const RegimeMap& map, const Scene& machine) {
  const int phases = map.disturbed ? map_phases : 1;
  std::vector<Scene> scenes;
  for (const MapColumn& column : columns) {
    for (int k = 0; k < phases; ++k) {
      scenes.push_back(with(machine, map.options.over.key, column.value));
      scenes.back().disturbance_phase += 2 * std::numbers::pi * k / phases;
    }
  }
  for (const double height : map.heights) {
    for (Scene& scene : scenes) {
      scene = with(std::move(scene), map.options.against.key, height);
      begin_turns_at_rest(scene);
    }
    if (map.disturbed) {
      columns.front().cells.push_back(loudest(scenes));
      continue;
    }
    const std::vector<Cell> cells = settled(scenes);
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].cells.push_back(cells[k]);
  }
}

void add_cells(RegimeMap& map, const Scene& machine) {
  const std::size_t together = map.disturbed ? 1 : Lanes::size;
  const std::size_t groups = (map.columns.size() + together - 1) / together;
  in_parallel("columns of the map", groups, [&](std::size_t i) {
    const std::span<MapColumn> all(map.columns);
    const std::size_t first = i * together;
    try {
      fill(all.subspan(first, std::min(together, all.size() - first)), map, machine);
    } catch (const TimeLimitReached&) {
      // The cells that had time stay.
    }
  });
}

double value_at(const RegimeMapOptions& options, int step, int steps) {
  return options.over.from + (options.over.to - options.over.from) * step / steps;
}

/// Follows a border from the machine's own constant through `values`, which lead away from it.
CurveEnd follow(BorderCurve curve, const std::vector<double>& values, const MapAxis& speeds,
                std::vector<MapPoint>& points) {
  for (const double value : values) {
    const bool arrives = curve.follow_to(value);
    const auto& [constant, omega, slope] = curve.here();
    if (omega < speeds.from || omega > speeds.to) return CurveEnd::speeds;
    if (arrives || points.empty() || points.back().constant != constant)
      points.push_back({constant, omega, slope});
    if (!arrives) return curve.end();
  }
  return CurveEnd::range;
}

/// The border of the machine that ends one of its regimes.
MapCurve followed(const Regime& slower, const Regime& faster, const RegimeMap& map) {
  const auto& [over, values, against] = map.options;
  MapCurve result{slower.ends_by,
                  slower.most_per_turn,
                  faster.most_per_turn,
                  {},
                  CurveEnd::not_sharp,
                  CurveEnd::not_sharp,
                  slower.to};
  std::vector<double> up, down;
  const int steps = parts * (values - 1);
  for (int k = 0; k <= steps; ++k) {
    const double value = value_at(map.options, k, steps);
    if (value > map.own) up.push_back(value);
    if (value < map.own) down.insert(down.begin(), value);
  }
  try {
    const BorderCurve curve(border_between(slower, faster), over.key);
    std::vector<MapPoint> left;
    result.begins = follow(curve, down, against, left);
    result.points.assign(left.rbegin(), left.rend());
    result.points.push_back({map.own, slower.to, curve.here().slope});
    result.ends = follow(curve, up, against, result.points);
  } catch (const std::invalid_argument&) {
    result.points.push_back({map.own, slower.to, std::nullopt});
  }
  std::erase_if(result.points, [&over = over](const MapPoint& point) {
    return point.constant < over.from || point.constant > over.to;
  });
  return result;
}

void add_borders(RegimeMap& map, const Scene& machine) {
  const MapAxis& speeds = map.options.against;
  const std::vector<Regime> regimes = regimes_of(machine, {speeds.from, speeds.to});
  if (regimes.back().ends_by == RegimeEnd::time_limit) map.complete = false;
  map.curves.resize(regimes.size() - 1);
  in_parallel("borders", map.curves.size(),
              [&](std::size_t i) { map.curves[i] = followed(regimes[i], regimes[i + 1], map); });
  std::erase_if(map.curves, [](const MapCurve& curve) { return curve.points.empty(); });
}

/// Where the columns first pass each of the lowest counts.
void add_levels(RegimeMap& map) {
  std::set<double> counts;
  for (const MapColumn& column : map.columns)
    for (const Cell& cell : column.cells)
      if (cell) counts.insert(*cell);
  const double half_cell = 0.5 * (map.heights[1] - map.heights[0]);
  for (auto count = counts.begin(); count != counts.end(); ++count) {
    const auto next = std::next(count);
    if (next == counts.end() || map.curves.size() == most_levels) return;
    MapCurve curve{{}, *count, *next, {}, CurveEnd::not_sharp, CurveEnd::not_sharp, {}};
    for (const MapColumn& column : map.columns) {
      const auto passes = std::ranges::find_if(column.cells, [&](const Cell& cell) {
        return (cell > *count) != (column.cells.front() > *count);
      });
      if (passes == column.cells.end()) continue;
      const auto k = static_cast<std::size_t>(passes - column.cells.begin());
      curve.points.push_back({column.value, map.heights[k] - half_cell, std::nullopt});
    }
    if (!curve.points.empty()) map.curves.push_back(std::move(curve));
  }
}

void check_axis(const MapAxis& axis, double least, double most) {
  if (axis.from < axis.to && axis.from >= least && axis.to <= most) return;
  throw InputError(fmt::format("{} {} to {}: must rise, within {}..{}", axis.key, axis.from,
                               axis.to, least, most));
}

/// The machine with both numbers, checked.
Scene corner(const Scene& machine, const RegimeMapOptions& options, double over, double against) {
  const Scene scene = with(with(machine, options.over.key, over), options.against.key, against);
  check(scene, fmt::format("{} {}, {} {}", options.over.key, over, options.against.key, against));
  return scene;
}

}  // namespace

RegimeMap regime_map(const Scene& machine, const RegimeMapOptions& options) {
  const auto& [over, values, against] = options;
  const bool of_speeds = against.key == "omega";
  RegimeMap map{options, constant_named(machine, over.key)};
  if (!of_speeds) constant_named(machine, against.key);
  if (over.key == against.key) throw InputError(over.key + ": must be two different constants");
  constexpr double highest = std::numeric_limits<double>::max();
  check_axis(over, -highest, highest);
  check_axis(against, of_speeds ? slowest_regime : -highest, of_speeds ? fastest_regime : highest);
  if (values < 2 || values > most_values)
    throw InputError(fmt::format("values: {} is not within 2..{}", values, most_values));
  check(machine, "scene");
  check_constant_speed(machine, "scene");
  check_regimes_exist(machine, "scene");
  Scene hard = machine;
  hard.fidelity = Fidelity::impact;
  map.disturbed = is_disturbed(hard);
  for (const double x : {over.from, over.to})
    for (const double y : {against.from, against.to})
      map.disturbed |= is_disturbed(corner(hard, options, x, y));
  for (int k = 0; k < map_heights; ++k)
    map.heights.push_back(against.from + (against.to - against.from) * (k + 0.5) / map_heights);
  for (int k = 0; k < values; ++k) map.columns.push_back({value_at(options, k, values - 1), {}});
  add_cells(map, hard);
  map.followed = of_speeds && !map.disturbed;
  map.complete = std::ranges::all_of(map.columns, [&](const MapColumn& column) {
    return column.cells.size() == map.heights.size();
  });
  try {
    map.followed ? add_borders(map, hard) : add_levels(map);
  } catch (const TimeLimitReached&) {
    map.complete = false;
  }
  return map;
}

}  // namespace ricochet::carrier_track::inline regimes
