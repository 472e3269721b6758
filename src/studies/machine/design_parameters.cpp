#include "src/studies/machine/design_parameters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/core/in_parallel.h"
#include "src/studies/machine/answer.h"
#include "src/studies/machine/charts.h"

namespace ricochet::studies::advice {

namespace {

using carrier_track::Scene;

/// A restitution after the design parameter's restitution goes from `own` to `value`: it moves by
/// the same share of the way to 0, or to 1.
double gone_with(double restitution, double own, double value) {
  if (value <= own) return own > 0 ? restitution * (value / own) : 0.0;
  return restitution + (1 - restitution) * (value - own) / (1 - own);
}

Scene with_restitution(const Scene& scene, double value) {
  const double own = scene.restitution_lower;
  Scene turned = scene;
  turned.restitution_lower = value;
  turned.restitution_upper = gone_with(scene.restitution_upper, own, value);
  if (turned.across) {
    turned.across->restitution_lower = gone_with(scene.across->restitution_lower, own, value);
    turned.across->restitution_upper = gone_with(scene.across->restitution_upper, own, value);
  }
  return turned;
}

Scene with_friction(const Scene& scene, double value) {
  Scene turned = scene;
  turned.friction = value;
  return turned;
}

double clearance_of(const Scene& scene) {
  return (scene.wall_upper - scene.wall_lower) / millimetre;
}

Scene with_clearance(const Scene& scene, double value) {
  return carrier_track::scaled(scene, "clearance", value / clearance_of(scene));
}

Scene with_disturbance(const Scene& scene, double value) {
  Scene turned = scene;
  turned.disturbance = value;
  return turned;
}

}  // namespace

double DesignParameter::value(double share) const {
  return share < 0 ? own + share * (own - least) : own + share * (most - own);
}

std::vector<double> DesignParameter::levels() const {
  std::vector<double> values;
  for (const double share : shares) {
    const double at = value(share);
    if (values.empty() || at != values.back()) values.push_back(at);
  }
  return values;
}

std::vector<DesignParameter> design_parameters_of(const Scene& scene) {
  const std::vector<double> three{-1, 0, 1};
  const std::vector<double> five{-1, -0.5, 0, 0.5, 1};
  const double restitution = scene.restitution_lower;
  const double friction = scene.friction;
  // With contact friction, a coefficient of 1 or more takes the whole velocity.
  const double slippery = scene.contact_friction ? std::max(friction, 0.99) : 1e15;
  std::vector<DesignParameter> design_parameters = {
      {"restitution", "", restitution / 2, restitution, (1 + restitution) / 2, five,
       with_restitution},
      {"friction", "", 0, friction, std::min(slippery, friction > 0 ? 2 * friction : 0.2), five,
       with_friction}};
  if (std::isfinite(scene.wall_upper)) {
    const double clearance = clearance_of(scene);
    design_parameters.push_back(
        {"clearance", "mm", clearance / 2, clearance, 2 * clearance, three, with_clearance});
  }
  const double force = std::max(std::abs(scene.pull), friction * scene.normal_force);
  if (scene.disturbance != 0) {
    design_parameters.push_back(
        {"disturbance", "N", 0, scene.disturbance, 2 * scene.disturbance, three, with_disturbance});
  } else if (force > 0) {
    design_parameters.push_back({"disturbance", "N", 0, 0, force, five, with_disturbance});
  }
  return design_parameters;
}

namespace {

using namespace carrier_track;
using report::Json;

/// 1 if the scene is loud at this speed, else 0.
int loudness(const Scene& scene, const Limit& limit, double omega) {
  return measured(at_speed(scene, omega), limit.measure) > limit.at_most ? 1 : 0;
}

/// The fastest speed up to which a disturbed machine is quiet in the long run, by the speeds of the
/// scan: its exact borders would take some seconds.
std::optional<double> quiet_by_scan(const Scene& scene, const Limit& limit,
                                    const CoarseScan& scan) {
  const auto is_quiet = [&](double omega) {
    return most_per_turn(at_speed(scene, omega)) <= limit.at_most;
  };
  double quiet = 0;
  double loud = scan.lowest;
  while (is_quiet(loud)) {
    quiet = loud;
    if (loud >= scan.highest) return loud;
    loud = std::min(scan.highest, loud * scan.ratio * scan.ratio);
  }
  if (quiet == 0) return std::nullopt;
  for (int halving = 0; halving < 5; ++halving) {
    const double middle = std::sqrt(quiet * loud);
    (is_quiet(middle) ? quiet : loud) = middle;
  }
  return quiet;
}

/// The same in the long run, where quiet and loud do not mix.
QuietRange found_in_the_long_run(const Scene& scene, const Limit& limit, const CoarseScan& scan) {
  QuietRange range;
  range.quiet = scene.disturbance == 0
                    ? quiet_up_to(scene, limit.at_most, {scan.lowest, scan.highest})
                    : quiet_by_scan(scene, limit, scan);
  range.to_the_end = range.quiet && *range.quiet >= scan.highest;
  return range;
}

QuietRange found(const Scene& scene, const Limit& limit, const CoarseScan& scan) {
  SpeedScan loud{1, {}};
  const auto omega = [&](double k) { return scan.lowest * std::pow(scan.ratio, k); };
  const int speeds =
      1 + static_cast<int>(std::floor(std::log(scan.highest / scan.lowest) / std::log(scan.ratio)));
  for (int k = 0; k < speeds; ++k) loud.counts.push_back(loudness(scene, limit, omega(k)));
  QuietRange range;
  const auto first = std::find(loud.counts.begin(), loud.counts.end(), 1);
  if (first == loud.counts.end()) {
    range.to_the_end = true;
    range.quiet = scan.highest;
  } else if (first != loud.counts.begin()) {
    auto louder = static_cast<double>(first - loud.counts.begin());
    double quieter = louder - 1;
    for (int halving = 0; halving < 4; ++halving) {
      const double middle = (quieter + louder) / 2;
      (loudness(scene, limit, omega(middle)) == 1 ? louder : quieter) = middle;
    }
    range.quiet = omega(quieter);
  }
  if (const auto place = best_split(loud, 0.5).speed) {
    range.divide = std::max(omega(*place - 1), range.quiet.value_or(0));
  }
  range.mixed = !range.divide && !range.to_the_end;
  return range;
}

/// The machine with the design parameter levels of a combination.
Scene turned(Scene scene, const DesignParameterGrid& grid, std::size_t combination) {
  for (std::size_t k = grid.design_parameters.size(); k-- > 0;) {
    const std::vector<double>& levels = grid.levels[k];
    const double value = levels[combination % levels.size()];
    combination /= levels.size();
    if (value != grid.design_parameters[k].own)
      scene = grid.design_parameters[k].turned(scene, value);
  }
  return scene;
}

double share_of_point(std::size_t i) {
  return -1 + 2.0 * static_cast<double>(i) / (DesignParameterGrid::points_of_a_line - 1);
}

/// Rounded to a ten-thousandth, which is finer than the scan's resolution.
Json four_decimals(const std::optional<double>& value) {
  return value ? Json(std::round(*value * 1e4) / 1e4) : Json();
}

Json change_of(const QuietRange& range, const QuietRange& own) {
  if (!range.quiet || !own.quiet) return {};
  return four_decimals(*range.quiet / *own.quiet - 1);
}

Json json_of(const QuietRange& range, const QuietRange& own) {
  return {{"quiet", four_decimals(range.quiet)},
          {"rpm", range.quiet ? four_decimals(*range.quiet * rpm) : Json()},
          {"change", change_of(range, own)},
          {"divide", four_decimals(range.divide)},
          {"mixed", range.mixed},
          {"to_the_end", range.to_the_end},
          {"simulated", range.simulated}};
}

std::string label_of(const DesignParameter& design_parameter) {
  return design_parameter.unit.empty() ? design_parameter.name
                                       : design_parameter.name + " [" + design_parameter.unit + "]";
}

Json points_of_line(const DesignParameterGrid& grid, std::size_t k) {
  Json points = Json::array();
  for (const QuietRange& range : grid.lines[k]) {
    Json point = json_of(range, grid.own);
    point["value"] = grid.design_parameters[k].value(share_of_point(points.size()));
    points.push_back(std::move(point));
  }
  return points;
}

/// The values of a design parameter on its line at which the machine is fastest and slowest.
Json ends_of_line(const DesignParameter& design_parameter, const Json& points) {
  const auto slower = [](const Json& a, const Json& b) { return a["quiet"] < b["quiet"]; };
  // Of equal points the machine's own value is preferred.
  const Json& own = points.at(DesignParameterGrid::points_of_a_line / 2);
  const Json& most = *std::max_element(points.begin(), points.end(), slower);
  const Json& least = *std::min_element(points.begin(), points.end(), slower);
  return {{"design_parameter", design_parameter.name},
          {"label", label_of(design_parameter)},
          {"unit", design_parameter.unit},
          {"least", design_parameter.least},
          {"own", design_parameter.own},
          {"most", design_parameter.most},
          {"matters", slower(own, most)},
          {"best", slower(own, most) ? most : own},
          {"worst", slower(least, own) ? least : own}};
}

}  // namespace

bool is_irregular(const Scene& scene, const QuietSpeed& answer) {
  return scene.disturbance == 0 &&
         std::any_of(answer.regimes.begin(), answer.regimes.end(),
                     [](const Regime& regime) { return !regime.certain; });
}

std::optional<CoarseScan> coarse_scan(const Scene& scene, const QuietSpeed& answer) {
  if (!answer.limit || is_irregular(scene, answer)) return std::nullopt;
  const double fastest = answer.options.fastest;
  return CoarseScan{answer.split.speed.value_or(fastest) / 8, fastest,
                    scene.fidelity == Fidelity::compliant ? 1.04 : 1.01};
}

QuietRange quiet_range(const Scene& scene, const Limit& limit, const CoarseScan& scan) {
  try {
    return is_of_the_long_run(scene, limit) ? found_in_the_long_run(scene, limit, scan)
                                            : found(scene, limit, scan);
  } catch (const std::runtime_error&) {  // more impacts or steps than a simulation may have
    QuietRange range;
    range.simulated = false;
    return range;
  }
}

std::optional<DesignParameterGrid> design_parameter_grid(const Scene& scene,
                                                         const QuietSpeed& answer) {
  const auto scan = coarse_scan(scene, answer);
  if (!scan) return std::nullopt;
  DesignParameterGrid grid{
      *scan, answer.is_of_the_long_run(), design_parameters_of(scene), {}, {}, {}, {}};
  std::size_t combinations = 1;
  for (const DesignParameter& design_parameter : grid.design_parameters) {
    grid.levels.push_back(design_parameter.levels());
    combinations *= grid.levels.back().size();
  }
  grid.combinations.resize(combinations);
  grid.lines.assign(grid.design_parameters.size(),
                    std::vector<QuietRange>(DesignParameterGrid::points_of_a_line));
  grid.own = quiet_range(scene, *answer.limit, grid.scan);
  const std::size_t of_lines =
      grid.design_parameters.size() * DesignParameterGrid::points_of_a_line;
  in_parallel("variants of the machine", combinations + of_lines, [&](std::size_t i) {
    if (i < combinations) {
      grid.combinations[i] = quiet_range(turned(scene, grid, i), *answer.limit, grid.scan);
      return;
    }
    const std::size_t k = (i - combinations) / DesignParameterGrid::points_of_a_line;
    const std::size_t point = (i - combinations) % DesignParameterGrid::points_of_a_line;
    const DesignParameter& design_parameter = grid.design_parameters[k];
    const double value = design_parameter.value(share_of_point(point));
    grid.lines[k][point] =
        quiet_range(value == design_parameter.own ? scene : design_parameter.turned(scene, value),
                    *answer.limit, grid.scan);
  });
  return grid;
}

Json json_of(const std::optional<DesignParameterGrid>& grid) {
  if (!grid) return {};
  Json design_parameters = Json::array();
  Json lines = Json::array();
  Json charts = Json::array();
  for (std::size_t k = 0; k < grid->design_parameters.size(); ++k) {
    const DesignParameter& design_parameter = grid->design_parameters[k];
    const auto& levels = grid->levels[k];
    const auto own = std::find(levels.begin(), levels.end(), design_parameter.own) - levels.begin();
    design_parameters.push_back({{"design_parameter", design_parameter.name},
                                 {"unit", design_parameter.unit},
                                 {"own", own},
                                 {"levels", levels}});
    Json points = points_of_line(*grid, k);
    lines.push_back(ends_of_line(design_parameter, points));
    charts.push_back({{"design_parameter", design_parameter.name},
                      {"label", label_of(design_parameter)},
                      {"own", design_parameter.own},
                      {"points", std::move(points)}});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Json& a, const Json& b) {
    return a["best"]["quiet"] > b["best"]["quiet"];  // null is less than any number
  });
  double top = grid->own.quiet.value_or(0);
  for (const auto& line : grid->lines) {
    for (const QuietRange& range : line) {
      top = std::max({top, range.quiet.value_or(0), range.divide.value_or(0)});
    }
  }
  Json own = json_of(grid->own, grid->own);
  return {{"from", grid->scan.lowest},
          {"to", grid->scan.highest},
          {"step", grid->scan.ratio - 1},
          {"in_window", !grid->long_run},
          {"combinations", grid->combinations.size()},
          {"own", std::move(own)},
          {"top", top > 0 ? 1.1 * top : 1},  // of all charts, which share one scale
          {"design_parameters", std::move(design_parameters)},
          {"lines", std::move(lines)},
          {"charts", std::move(charts)},
          {"answers", report::list_of(grid->combinations, [&](const QuietRange& range) {
             return json_of(range, grid->own);
           })}};
}

}  // namespace ricochet::studies::advice
