#include "src/studies/machine/design_parameters.h"

#include <fmt/format.h>

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

std::vector<DesignParameter> design_parameters_of(const Scene& scene) {
  const double restitution = scene.restitution_lower;
  const double friction = scene.friction;
  // With contact friction, a coefficient of 1 or more takes the whole velocity.
  const double slippery = scene.contact_friction ? std::max(friction, 0.99) : 1e15;
  std::vector<DesignParameter> design_parameters = {
      {"restitution", "", restitution / 2, restitution, (1 + restitution) / 2, with_restitution},
      {"friction", "", 0, friction, std::min(slippery, friction > 0 ? 2 * friction : 0.2),
       with_friction}};
  if (std::isfinite(scene.wall_upper)) {
    const double clearance = clearance_of(scene);
    design_parameters.push_back(
        {"clearance", "mm", clearance / 2, clearance, 2 * clearance, with_clearance});
  }
  const double force = std::max(std::abs(scene.pull), friction * scene.normal_force);
  if (scene.disturbance != 0) {
    design_parameters.push_back(
        {"disturbance", "N", 0, scene.disturbance, 2 * scene.disturbance, with_disturbance});
  } else if (force > 0) {
    design_parameters.push_back({"disturbance", "N", 0, 0, force, with_disturbance});
  }
  return design_parameters;
}

namespace {

using namespace carrier_track;

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
  return range;
}

double share_of_point(std::size_t i) {
  return -1 + 2.0 * static_cast<double>(i) / (DesignLines::points_of_a_line - 1);
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
    return {};
  }
}

std::optional<DesignLines> design_lines(const Scene& scene, const QuietSpeed& answer) {
  const auto scan = coarse_scan(scene, answer);
  if (!scan) return std::nullopt;
  constexpr std::size_t points = DesignLines::points_of_a_line;
  DesignLines all{*scan, answer.is_of_the_long_run(), design_parameters_of(scene), {}, {}};
  all.lines.assign(all.design_parameters.size(), std::vector<QuietRange>(points));
  all.own = quiet_range(scene, *answer.limit, all.scan);
  in_parallel("variants of the machine", all.lines.size() * points, [&](std::size_t i) {
    const DesignParameter& one = all.design_parameters[i / points];
    const double value = one.value(share_of_point(i % points));
    all.lines[i / points][i % points] =
        quiet_range(value == one.own ? scene : one.turned(scene, value), *answer.limit, all.scan);
  });
  return all;
}

namespace {

std::string label_of(const DesignParameter& one) {
  return one.unit.empty() ? one.name : fmt::format("{} [{}]", one.name, one.unit);
}

/// A point of a line.
struct Point {
  double value;
  QuietRange range;
};

bool is_slower(const Point& a, const Point& b) {
  return a.range.quiet < b.range.quiet;  // nothing is less than any number
}

std::vector<Point> points_of(const DesignLines& lines, std::size_t k) {
  std::vector<Point> points;
  for (const QuietRange& range : lines.lines[k]) {
    points.push_back({lines.design_parameters[k].value(share_of_point(points.size())), range});
  }
  return points;
}

/// A design parameter, and where on its line the machine is fastest and slowest.
struct Ends {
  const DesignParameter* parameter;
  Point best, worst;
  bool matters;  ///< a value is faster than the machine's own
};

Ends ends_of(const DesignLines& lines, std::size_t k) {
  const std::vector<Point> points = points_of(lines, k);
  // Of equal points the machine's own value is preferred.
  const Point& own = points[points.size() / 2];
  const Point& most = *std::ranges::max_element(points, is_slower);
  const Point& least = *std::ranges::min_element(points, is_slower);
  const bool matters = is_slower(own, most);
  return {&lines.design_parameters[k], matters ? most : own, is_slower(least, own) ? least : own,
          matters};
}

std::optional<double> change_of(const QuietRange& range, const QuietRange& own) {
  return range.quiet && own.quiet ? std::optional(*range.quiet / *own.quiet - 1) : std::nullopt;
}

Table table_of(const std::vector<Ends>& all, const QuietRange& own) {
  Table table{"design-parameters",
              {{"design_parameter", "design parameter"},
               {"own", "its own", ".3g"},
               {"least", "tried from", ".3g"},
               {"most", "to", ".3g"},
               {"best", "fastest at", ".3g"},
               {"best_quiet", "quiet up to [rad/s]", ".3f"},
               {"best_rpm", "[rpm]", ".1f"},
               {"best_change", "change [%]", "+.1%"},
               {"worst", "slowest at", ".3g"},
               {"worst_quiet", "quiet up to [rad/s]", ".3f"},
               {"worst_change", "change [%]", "+.1%"}}};
  for (const Ends& one : all) {
    const auto& best = one.best.range.quiet;
    table.add(label_of(*one.parameter), one.parameter->own, one.parameter->least,
              one.parameter->most, one.best.value, best,
              best ? std::optional(*best * rpm) : std::nullopt, change_of(one.best.range, own),
              one.worst.value, one.worst.range.quiet, change_of(one.worst.range, own));
  }
  return table;
}

/// The gain from the first; nothing if no value is faster than the machine's own.
std::optional<std::string> sentence_of(const std::vector<Ends>& all, const QuietRange& own) {
  if (all.empty() || !all.front().matters) return std::nullopt;
  const auto& [parameter, best, worst, matters] = all.front();
  const std::string unit = parameter->unit.empty() ? "" : " " + parameter->unit;
  const auto change = change_of(best.range, own);
  return fmt::format(
      "Of the design parameters the {} has the largest effect: at {:.3g}{} in place of {:.3g} the "
      "machine would be {}.",
      parameter->name, best.value, unit, parameter->own,
      best.range.to_the_end
          ? "quiet at every speed that was tried"
          : fmt::format("quiet up to {:.3f} rad/s{}", *best.range.quiet,
                        change ? fmt::format(" ({:+.0f} %)", 100 * *change) : ""));
}

/// `top` [rad/s] is the end of the axis, one for all.
report::Chart chart_of(const DesignLines& lines, std::size_t k, double top) {
  const DesignParameter& parameter = lines.design_parameters[k];
  report::Series quiet{"quiet up to here", report::Mark::points, {}};
  report::Series divide{"quiet and loud divide", report::Mark::line, {}, true};
  for (const auto& [value, range] : points_of(lines, k)) {
    quiet.samples.push_back({value, range.quiet});
    divide.samples.push_back({value, range.divide});
  }
  report::Chart chart{.name = "line",
                      .title = "Fastest quiet speed over " + parameter.name,
                      .x = {label_of(parameter)},
                      .y = {.label = "speed [rad/s]", .range = report::Range{0, top}},
                      .series = {std::move(quiet)},
                      .lines = {{report::Direction::vertical, parameter.own, "its own"}}};
  if (!lines.long_run) chart.series.push_back(std::move(divide));
  return chart;
}

std::string method_of(const DesignLines& lines) {
  const CoarseScan& scan = lines.scan;
  if (lines.long_run) {
    return fmt::format(
        "Each variant is a machine of its own, whose long run is followed from {:.3f} to {:.3f} "
        "rad/s until some turn has more collisions than the limit. That border is solved; with a "
        "disturbance, it is bracketed between speeds 2 % apart and halved five times.",
        scan.lowest, scan.highest);
  }
  return fmt::format(
      "Each variant is simulated at speeds from {:.3f} to {:.3f} rad/s, each {:.0f} % faster than "
      "the one before; between the last quiet and the first loud one four halvings follow. A loud "
      "interval narrower than that can be missed; the answer at the head, at steps of 0.001 "
      "rad/s, does not miss it. Quiet and loud divide at the speed that puts the fewest speeds on "
      "the wrong side.",
      scan.lowest, scan.highest, 100 * (scan.ratio - 1));
}

}  // namespace

void add_design(const std::optional<DesignLines>& lines, report::Results& results) {
  std::vector<Ends> all;
  double top = 0;
  for (std::size_t k = 0; lines && k < lines->lines.size(); ++k) {
    all.push_back(ends_of(*lines, k));
    for (const QuietRange& range : lines->lines[k]) {
      top = std::max({top, range.quiet.value_or(0), range.divide.value_or(0)});
    }
  }
  std::ranges::stable_sort(all,
                           [](const Ends& a, const Ends& b) { return is_slower(b.best, a.best); });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto place = static_cast<std::size_t>(all[k].parameter - lines->design_parameters.data());
    report::Results own;
    own.add(chart_of(*lines, place, top > 0 ? 1.1 * top : 1));
    results.add("design", {all[k].parameter->name, all[k].parameter->name, std::move(own)});
  }
  const QuietRange own = lines ? lines->own : QuietRange{};
  results.set("design", sentence_of(all, own));
  results.set("design-own", own.quiet);
  results.set("design-method", lines ? std::optional(method_of(*lines)) : std::nullopt);
  results.add(table_of(all, own));
}

}  // namespace ricochet::studies::advice
