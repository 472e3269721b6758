#include "src/studies/machine/design_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/quiet_speed.h"
#include "src/core/in_parallel.h"
#include "src/studies/machine/answer.h"
#include "src/studies/machine/charts.h"

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;

/// A restitution after the design parameter's restitution goes from `own` to `value`: it moves by
/// the same share of the way to 0, or to 1.
double gone_with(double restitution, double own, double value) {
  if (value <= own) return own > 0 ? restitution * (value / own) : 0.0;
  return restitution + (1 - restitution) * (value - own) / (1 - own);
}

Scene with_restitution(Scene scene, double value) {
  const double own = scene.restitution_lower;
  const auto turn = [&](double& restitution) { restitution = gone_with(restitution, own, value); };
  turn(scene.restitution_lower);
  turn(scene.restitution_upper);
  if (scene.across) {
    turn(scene.across->restitution_lower);
    turn(scene.across->restitution_upper);
  }
  return scene;
}

double clearance_of(const Scene& scene) {
  return (scene.wall_upper - scene.wall_lower) / millimetre;
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
  std::vector<DesignParameter> all = {
      {"restitution", "", restitution / 2, restitution, (1 + restitution) / 2, with_restitution},
      {"friction", "", 0, friction, std::min(slippery, friction > 0 ? 2 * friction : 0.2),
       [](Scene turned, double value) {
         turned.friction = value;
         return turned;
       }}};
  if (std::isfinite(scene.wall_upper)) {
    const double clearance = clearance_of(scene);
    all.push_back(
        {"clearance", "mm", clearance / 2, clearance, 2 * clearance,
         [](Scene turned, double value) {  // NOLINT(performance-unnecessary-value-param): one type
           return scaled(turned, "clearance", value / clearance_of(turned));
         }});
  }
  const double force = std::max(std::abs(scene.pull), friction * scene.normal_force);
  const double most = scene.disturbance != 0 ? 2 * scene.disturbance : force;
  if (most != 0) {
    all.push_back({"disturbance", "N", 0, scene.disturbance, most, [](Scene turned, double value) {
                     turned.disturbance = value;
                     return turned;
                   }});
  }
  return all;
}

bool is_irregular(const Scene& scene, const QuietSpeed& answer) {
  const auto is_certain = [](const Regime& regime) { return regime.certain; };
  return scene.disturbance == 0 && !std::ranges::all_of(answer.regimes, is_certain);
}

std::optional<CoarseScan> coarse_scan(const Scene& scene, const QuietSpeed& answer) {
  if (!answer.limit || is_irregular(scene, answer)) return std::nullopt;
  const double ratio = scene.fidelity == Fidelity::compliant ? 1.04
                       : answer.is_of_the_long_run()         ? 1.02
                                                             : 1.01;
  const double fastest = answer.options.fastest;
  return CoarseScan{answer.split.speed.value_or(fastest) / 8, fastest, ratio};
}

std::optional<double> quiet_by_scan(const Scene& scene, const Limit& limit,
                                    const CoarseScan& scan) {
  const bool long_run = is_of_the_long_run(scene, limit);
  const auto is_quiet = [&](double omega) {
    const Scene there = at_speed(scene, omega);
    return (long_run ? most_per_turn(there) : measured(there, limit.measure)) <= limit.at_most;
  };
  try {
    if (long_run && scene.disturbance == 0)
      return quiet_up_to(scene, limit.at_most, {scan.lowest, scan.highest});
    std::optional<double> quiet;
    double loud = scan.lowest;
    while (is_quiet(loud)) {
      quiet = loud;
      if (loud >= scan.highest) return quiet;
      loud = std::min(scan.highest, loud * scan.ratio);
    }
    for (int halving = 0; quiet && halving < 4; ++halving) {
      const double middle = std::sqrt(*quiet * loud);
      if (is_quiet(middle)) {
        quiet = middle;
      } else {
        loud = middle;
      }
    }
    return quiet;
  } catch (const std::runtime_error&) {  // more impacts or steps than a simulation may have
    return std::nullopt;
  }
}

std::vector<DesignLine> design_lines(const Scene& scene, const QuietSpeed& answer) {
  const auto scan = coarse_scan(scene, answer);
  if (!scan) return {};
  constexpr std::size_t points = DesignLine::points;
  std::vector<DesignLine> lines;
  for (const DesignParameter& parameter : design_parameters_of(scene)) {
    DesignLine line{parameter, {}, std::vector<std::optional<double>>(points)};
    for (std::size_t i = 0; i < points; ++i)
      line.values.push_back(parameter.value(-1 + 2.0 * static_cast<double>(i) / (points - 1)));
    lines.push_back(std::move(line));
  }
  in_parallel("variants of the machine", lines.size() * points, [&](std::size_t i) {
    DesignLine& line = lines[i / points];
    const double value = line.values[i % points];
    const Scene turned = value == line.parameter.own ? scene : line.parameter.turned(scene, value);
    line.quiet[i % points] = quiet_by_scan(turned, *answer.limit, *scan);
  });
  return lines;
}

namespace {

std::string label_of(const DesignParameter& one) {
  return one.unit.empty() ? one.name : fmt::format("{} [{}]", one.name, one.unit);
}

/// Where on its line the machine is fastest and slowest; of equal points its own value.
struct Ends {
  const DesignLine* line;
  std::size_t own, best, worst;  ///< points
  std::optional<double> quiet;   ///< [rad/s], at the best

  explicit Ends(const DesignLine& of)
      : line(&of), own(of.values.size() / 2), best(own), worst(own) {
    for (std::size_t i = 0; i < of.quiet.size(); ++i) {  // nothing is less than any number
      if (of.quiet[i] > of.quiet[best]) best = i;
      if (of.quiet[i] < of.quiet[worst]) worst = i;
    }
    quiet = of.quiet[best];
  }

  std::optional<double> change(std::size_t point) const {
    const auto& there = line->quiet[point];
    const auto& here = line->quiet[own];
    return there && here ? std::optional(*there / *here - 1) : std::nullopt;
  }
};

Table table_of(const std::vector<Ends>& all) {
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
  for (const Ends& ends : all) {
    const auto& [parameter, values, quiet] = *ends.line;
    table.add(label_of(parameter), parameter.own, parameter.least, parameter.most,
              values[ends.best], ends.quiet,
              ends.quiet ? std::optional(*ends.quiet * rpm) : std::nullopt, ends.change(ends.best),
              values[ends.worst], quiet[ends.worst], ends.change(ends.worst));
  }
  return table;
}

/// The largest gain; nothing if no value is faster than the machine's own.
std::optional<std::string> sentence_of(const std::vector<Ends>& all, double highest) {
  if (all.empty() || all.front().best == all.front().own) return std::nullopt;
  const Ends& ends = all.front();
  const DesignParameter& parameter = ends.line->parameter;
  const auto change = ends.change(ends.best);
  return fmt::format(
      "Of the design parameters the {} has the largest effect: at {:.3g}{} in place of {:.3g} the "
      "machine would be {}.",
      parameter.name, ends.line->values[ends.best],
      parameter.unit.empty() ? "" : " " + parameter.unit, parameter.own,
      *ends.quiet >= highest
          ? "quiet at every speed that was tried"
          : fmt::format("quiet up to {:.3f} rad/s{}", *ends.quiet,
                        change ? fmt::format(" ({:+.0f} %)", 100 * *change) : ""));
}

/// `top` [rad/s] is the end of the axis, one for all.
report::Chart chart_of(const DesignLine& line, double top) {
  report::Series quiet{"quiet up to here", report::Mark::points, {}};
  for (std::size_t i = 0; i < line.values.size(); ++i)
    quiet.samples.push_back({line.values[i], line.quiet[i]});
  return {.name = "line",
          .title = "Fastest quiet speed over " + line.parameter.name,
          .x = {label_of(line.parameter)},
          .y = {.label = "speed [rad/s]", .range = report::Range{0, top}},
          .series = {std::move(quiet)},
          .lines = {{report::Direction::vertical, line.parameter.own, "its own"}}};
}

std::string method_of(const CoarseScan& scan, bool long_run) {
  return fmt::format(
      "Each variant is a machine of its own. {} speeds from {:.3f} to {:.3f} rad/s, each {:.0f} % "
      "faster than the one before, up to the first loud one; between that and the last quiet one "
      "four halvings follow. A loud interval narrower than that can be missed{}.",
      long_run ? "Without a disturbance its border is solved; with one its long run is simulated at"
               : "It is simulated at",
      scan.lowest, scan.highest, 100 * (scan.ratio - 1),
      long_run ? "" : "; the answer at the head, at steps of 0.001 rad/s, does not miss it");
}

}  // namespace

void add_design(const std::vector<DesignLine>& lines, const QuietSpeed& answer,
                const std::optional<CoarseScan>& scan, report::Results& results) {
  std::vector<Ends> all;
  double top = 0;
  for (const DesignLine& line : lines) {
    all.emplace_back(line);
    top = std::max(top, all.back().quiet.value_or(0));
  }
  std::ranges::stable_sort(all, std::greater<>(), &Ends::quiet);
  for (const Ends& ends : all) {
    report::Results own;
    own.add(chart_of(*ends.line, top > 0 ? 1.1 * top : 1));
    const std::string& name = ends.line->parameter.name;
    results.add("design", {name, name, std::move(own)});
  }
  results.set("design", sentence_of(all, answer.options.fastest));
  results.set("design-own", all.empty() ? std::nullopt : all.front().line->quiet[all.front().own]);
  results.set("design-method", all.empty()
                                   ? std::nullopt
                                   : std::optional(method_of(*scan, answer.is_of_the_long_run())));
  results.add(table_of(all));
}

}  // namespace ricochet::studies::advice
