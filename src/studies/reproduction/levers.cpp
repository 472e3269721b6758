#include "src/studies/reproduction/levers.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/studies/machine/charts.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;

/// [m/s], between which the effect of the counting limit is told: nobody measured it.
constexpr double low_limit = 1e-3, high_limit = 10e-3;

/// Restitutions in thousandths, so that one of a case is met exactly: closer where curves are
/// steep.
std::vector<int> thousandths_of(bool disturbed, bool coarse) {
  if (disturbed) return {50, 75, 100, 150, 200, 300, 400, 500, 600, 700, 800, 900, 950};
  std::vector<int> all;
  for (int thousandths = 50; thousandths <= 950; thousandths += coarse ? 50 : 25) {
    all.push_back(thousandths);
  }
  return all;
}

std::optional<double> threshold_of(const Scene& scene, double highest) {
  if (!has_regimes(scene)) return std::nullopt;
  const auto speed = quiet_up_to(scene, quiet_per_turn, {slowest_speed, highest});
  return speed && *speed < highest ? speed : std::nullopt;
}

/// Computes all points of the curves; `scene_of` makes the machine of a curve at a value.
void solve(std::vector<ThresholdCurve>& curves, double highest, const char* what,
           const std::function<Scene(const Case&, double)>& scene_of) {
  std::vector<std::pair<const Case*, CurvePoint*>> all;
  for (ThresholdCurve& curve : curves) {
    for (CurvePoint& point : curve.points) all.emplace_back(&curve.machine, &point);
  }
  Progress progress(what, static_cast<double>(all.size()));
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    const auto [machine, point] = all[i];
    point->speed = threshold_of(scene_of(*machine, point->value), highest);
    progress.advance(1);
  });
}

/// Values that rise evenly on a logarithmic axis, with those that are to be met exactly.
std::vector<double> logarithmic(double from, double to, int number, std::set<double> exact) {
  for (int k = 0; k < number; ++k) exact.insert(from * std::pow(to / from, k / (number - 1.0)));
  return {exact.begin(), exact.end()};
}

std::optional<double> speed_at(const ThresholdCurve& curve, double value) {
  for (const CurvePoint& point : curve.points) {
    if (point.value == value) return point.speed;
  }
  return std::nullopt;
}

/// Adds a pair to an effect.
void take(std::optional<EndEffect>& effect, double from, double to, double ratio) {
  if (!effect) effect = EndEffect{from, to, ratio, ratio, 0};
  effect->least = std::min(effect->least, ratio);
  effect->most = std::max(effect->most, ratio);
  ++effect->pairs;
}

std::string extent(double least, double most, const char* form) {
  const std::string first = fmt::format(fmt::runtime(form), least);
  const std::string last = fmt::format(fmt::runtime(form), most);
  return first == last ? first : first + " to " + last;
}

}  // namespace

std::vector<ThresholdCurve> restitution_curves(const std::vector<Case>& cases,
                                               const Scene& interpretation, bool coarse,
                                               double highest) {
  std::set<double> frictions, disturbances;
  for (const Case& c : cases) {
    frictions.insert(c.friction);
    disturbances.insert(coarse ? 0 : c.disturbance);
  }
  std::vector<ThresholdCurve> curves;
  for (const double friction : frictions) {
    for (const double disturbance : disturbances) {
      ThresholdCurve curve{{"", 0, friction, disturbance, {}}, {}};
      for (const int thousandths : thousandths_of(disturbance != 0, coarse))
        curve.points.push_back({thousandths / 1000.0, {}});
      curves.push_back(std::move(curve));
    }
  }
  solve(curves, highest, "thresholds over restitution", [&](Case machine, double value) {
    machine.restitution = value;
    return scene_of(machine, interpretation);
  });
  return curves;
}

std::vector<ThresholdCurve> curves_over(const std::string& key, const std::vector<double>& values,
                                        const std::vector<Case>& cases, const Scene& interpretation,
                                        double highest) {
  std::vector<ThresholdCurve> curves;
  for (const Case& c : cases) {
    if (c.disturbance != 0) continue;
    ThresholdCurve curve{c, {}};
    for (const double value : values) curve.points.push_back({value, {}});
    curves.push_back(std::move(curve));
  }
  solve(curves, highest, ("thresholds over " + key).c_str(),
        [&](const Case& machine, double value) {
          const Scene scene = scene_of(machine, interpretation);
          const double own =
              key == "clearance" ? scene.wall_upper - scene.wall_lower : scene.counting_limit;
          return value == own ? scene : scaled(scene, key, value / own);
        });
  return curves;
}

std::optional<EndEffect> effect_of(double Case::*constant, const std::vector<QuietCase>& cases) {
  const auto value = [&](const QuietCase& one) { return one.the_case.*constant; };
  const auto [low, high] = std::ranges::minmax_element(cases, {}, value);
  std::optional<EndEffect> effect;
  if (low == cases.end() || value(*low) == value(*high)) return effect;
  const double from = value(*low), to = value(*high);
  for (const QuietCase& slow : cases) {
    for (const QuietCase& fast : cases) {
      Case same = slow.the_case;
      same.*constant = to;
      const Case& other = fast.the_case;
      const bool pair = value(slow) == from && same.restitution == other.restitution &&
                        same.friction == other.friction && same.disturbance == other.disturbance;
      if (pair && slow.speed && fast.speed) take(effect, from, to, *fast.speed / *slow.speed);
    }
  }
  return effect;
}

std::optional<EndEffect> effect_of(const std::vector<ThresholdCurve>& curves, double from,
                                   double to) {
  std::optional<EndEffect> effect;
  for (const ThresholdCurve& curve : curves) {
    const auto first = speed_at(curve, from), last = speed_at(curve, to);
    if (first && last) take(effect, from, to, *last / *first);
  }
  return effect;
}

std::string told(const EndEffect& effect) {
  constexpr double as_a_factor = 1.25;  // from here on a ratio is told as a factor
  const double least = effect.least, most = effect.most;
  const auto percent = [](double ratio) { return 100 * std::abs(ratio - 1); };
  if (least >= as_a_factor) return "multiplies it by " + extent(least, most, "{:.1f}");
  if (most <= 1 / as_a_factor) return "divides it by " + extent(1 / most, 1 / least, "{:.1f}");
  if (most <= 1)
    return fmt::format("lowers it by {} %", extent(percent(most), percent(least), "{:.1f}"));
  if (least >= 1)
    return fmt::format("raises it by {} %", extent(percent(least), percent(most), "{:.1f}"));
  return fmt::format("changes it by -{:.1f} to +{:.1f} %", percent(least), percent(most));
}

Levers levers_of(const std::vector<QuietCase>& cases, const Scene& interpretation, bool coarse,
                 double highest) {
  Levers levers;
  std::vector<Case> all;
  for (const QuietCase& c : cases) all.push_back(c.the_case);
  levers.over_restitution = restitution_curves(all, interpretation, coarse, highest);
  const int number = coarse ? 9 : 25;
  const double clearance = interpretation.wall_upper - interpretation.wall_lower;
  levers.over_counting_limit =
      curves_over("counting_limit",
                  logarithmic(0.5e-3, 20e-3, number,
                              {low_limit, 3e-3, interpretation.counting_limit, high_limit}),
                  all, interpretation, highest);
  levers.over_clearance =
      curves_over("clearance",
                  logarithmic(clearance / 4, clearance * 4, number, {clearance / 2, 2 * clearance}),
                  all, interpretation, highest);
  for (const QuietCase& c : cases) {
    if (c.the_case.disturbance != 0 || !c.speed) continue;
    const Limit limit{Measure::collisions_per_turn, quiet_per_turn};
    levers.exponents.push_back(
        {c.the_case.id, sensitivities(scene_of(c.the_case, interpretation), limit, *c.speed)});
  }
  return levers;
}

namespace {

using report::Chart;
using report::Mark;

std::string in_words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

/// The fastest quiet speeds over a constant of this unit.
Chart chart_over(std::string name, std::string title, std::string label, double unit,
                 const std::vector<ThresholdCurve>& curves) {
  Chart chart{.name = std::move(name),
              .title = std::move(title),
              .x = {.label = std::move(label)},
              .y = {.label = "fastest quiet speed [rad/s]", .scale = report::Scale::logarithmic}};
  for (const ThresholdCurve& curve : curves) {
    const Case& machine = curve.machine;
    report::Series series{
        machine.id.empty()
            ? fmt::format("friction {}, disturbance {} N", machine.friction, machine.disturbance)
            : fmt::format("{}: restitution {}, friction {}", machine.id, machine.restitution,
                          machine.friction),
        Mark::line,
        {}};
    for (const CurvePoint& point : curve.points)
      series.samples.push_back({point.value / unit, point.speed});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// With the paper's cases as points.
Chart restitution_chart(const Levers& levers, const std::vector<CaseStudy>& cases) {
  const auto slower = effect_of(levers.over_restitution, 0.1, 0.9);
  double least_kept = 1, disturbance = 0;
  for (const ThresholdCurve& shaken : levers.over_restitution) {
    disturbance = std::max(disturbance, shaken.machine.disturbance);
  }
  for (const ThresholdCurve& still : levers.over_restitution) {
    for (const ThresholdCurve& shaken : levers.over_restitution) {
      if (still.machine.friction != shaken.machine.friction || still.machine.disturbance != 0 ||
          shaken.machine.disturbance != disturbance)
        continue;
      for (const CurvePoint& point : shaken.points) {
        const auto from = speed_at(still, point.value);
        if (from && point.speed) least_kept = std::min(least_kept, *point.speed / *from);
      }
    }
  }
  std::string title = "The fastest quiet speed falls with the restitution";
  if (slower) {
    title = fmt::format("Restitution 0.1 in place of 0.9 lets the machine turn {} times as fast",
                        extent(1 / slower->most, 1 / slower->least, "{:.1f}"));
  }
  if (least_kept < 1) {
    title += fmt::format("; a disturbance of {} N costs at most {:.0f} %", disturbance,
                         100 * (1 - least_kept));
  }
  Chart chart =
      chart_over("threshold-over-restitution", title, "restitution", 1, levers.over_restitution);
  chart.x.range = report::Range{0, 1};
  chart.width = 720;
  chart.height = 400;
  report::Series paper{.label = "paper", .mark = Mark::points, .samples = {}, .dark = true};
  for (const CaseStudy& c : cases) {
    const auto threshold = c.the_case.claim.threshold;
    if (threshold) paper.samples.push_back({c.the_case.restitution, threshold, {}, c.the_case.id});
  }
  chart.series.push_back(std::move(paper));
  return chart;
}

/// Over a constant that is not a case's, on logarithmic axes, where an exponent is a slope.
Chart fitted_chart(std::string name, std::string title, std::string label, double own,
                   const std::vector<ThresholdCurve>& curves) {
  Chart chart = chart_over(std::move(name), std::move(title), std::move(label), millimetre, curves);
  chart.x.scale = report::Scale::logarithmic;
  chart.lines = {{report::Direction::vertical, own / millimetre, "fitted"}};
  return chart;
}

/// A row for each constant that moves the speed, a column for each case; the largest first.
Table exponents_table(const Levers& levers, const FittedInterpretation& interpretation) {
  Table table{"exponents", {{"constant"}, {"known"}}};
  for (const CaseExponents& one : levers.exponents)
    table.columns.push_back({one.id, one.id, "+.2f"});
  table.columns.push_back({"largest"});
  std::vector<std::string> keys;
  for (const CaseExponents& one : levers.exponents) {
    for (const Sensitivity& s : one.exponents)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  }
  for (const std::string& key : keys) {
    std::string known = key == "restitution" || key == "friction" ? "the paper's" : "fixed";
    for (const Unknown free : interpretation.free)
      if (unknown_parameters()[static_cast<std::size_t>(free)].name == key) known = "fitted";
    std::vector<Value> row = {in_words(key), known};
    double largest = 0;
    for (const CaseExponents& one : levers.exponents) {
      const auto found = std::ranges::find(one.exponents, key, &Sensitivity::key);
      const bool there = found != one.exponents.end();
      row.push_back(there ? value_of(found->percent) : Value());
      if (there) largest = std::max(largest, std::abs(found->percent));
    }
    row.emplace_back(largest);
    if (largest >= 0.005) table.add_row(std::move(row));
  }
  std::vector<std::string> shown;
  for (const Column& column : table.columns) shown.push_back(column.name);
  shown.pop_back();
  return only(sorted(std::move(table), {"-largest"}), shown);
}

/// "restitution -0.84 %, counting limit +0.82 %": of the first case, as far as they can be seen.
std::optional<std::string> exponents_of_first(const Levers& levers) {
  if (levers.exponents.empty()) return {};
  std::string text;
  for (const Sensitivity& s : levers.exponents.front().exponents) {
    if (std::abs(s.percent) < 0.005) continue;
    text += fmt::format("{}{} {:+.2f} %", text.empty() ? "" : ", ", in_words(s.key), s.percent);
  }
  return fmt::format(
      "One per cent more of a constant moves the fastest quiet speed of {} by: {}. The counting "
      "limit, the speed from which an impact counts as a collision, is fitted to the paper's "
      "thresholds and not measured.",
      levers.exponents.front().id, text);
}

/// The speeds of the first case over the counting limit.
std::string over_limit(const Levers& levers, double own) {
  std::string limits, speeds;
  if (levers.over_counting_limit.empty()) return "";
  const ThresholdCurve& first = levers.over_counting_limit.front();
  for (const double limit : {low_limit, 3e-3, own, high_limit}) {
    const auto speed = speed_at(first, limit);
    if (!speed) continue;
    const std::string between = limits.empty() ? "" : limit == high_limit ? " and " : ", ";
    limits += between + fmt::format("{:.3g}", limit / millimetre);
    speeds += between + fmt::format("{:.2f}", *speed);
  }
  return fmt::format(" With limits of {} mm/s {} is quiet up to {} rad/s.", limits,
                     first.machine.id, speeds);
}

std::string from_end_to_end(const Levers& levers, const std::vector<QuietCase>& cases,
                            double clearance) {
  std::string text;
  const auto add = [&](const std::string& name, const std::optional<EndEffect>& effect, double unit,
                       const char* unit_name) {
    if (!effect) return;
    text += fmt::format("{}{} from {:.2g} to {:.2g}{} {}", text.empty() ? "" : "; ", name,
                        effect->from / unit, effect->to / unit, unit_name, told(*effect));
  };
  add("counting limit", effect_of(levers.over_counting_limit, low_limit, high_limit), millimetre,
      " mm/s");
  add("restitution", effect_of(&Case::restitution, cases), 1, "");
  add("clearance", effect_of(levers.over_clearance, clearance / 2, 2 * clearance), millimetre,
      " mm");
  add("friction", effect_of(&Case::friction, cases), 1, "");
  add("disturbance", effect_of(&Case::disturbance, cases), 1, " N");
  return text.empty() ? text : "From end to end, in the paper's cases: " + text + ".";
}

}  // namespace

void add_levers(const Findings& findings, report::Results& results) {
  const Levers& levers = findings.levers;
  const Scene& scene = findings.interpretation.scene;
  const double clearance = scene.wall_upper - scene.wall_lower;
  const auto moves = exponents_of_first(levers);
  const std::string ends = from_end_to_end(levers, quiet_cases(findings.cases), clearance);
  results.set("moves", moves ? std::optional(*moves + over_limit(levers, scene.counting_limit))
                             : std::nullopt);
  results.set("from_end_to_end", ends.empty() ? std::nullopt : std::optional(ends));
  results.add(exponents_table(levers, findings.interpretation));
  results.add(restitution_chart(levers, findings.cases));
  const auto by_limit = effect_of(levers.over_counting_limit, low_limit, high_limit);
  results.add(fitted_chart(
      "threshold-over-counting-limit",
      by_limit ? fmt::format("A counting limit of {:.2g} in place of {:.2g} mm/s: {} times as fast",
                             high_limit / millimetre, low_limit / millimetre,
                             extent(by_limit->least, by_limit->most, "{:.1f}"))
               : "The fastest quiet speed over the counting limit",
      "counting limit [mm/s]", scene.counting_limit, levers.over_counting_limit));
  const auto by_clearance = effect_of(levers.over_clearance, clearance / 2, 2 * clearance);
  results.add(fitted_chart(
      "threshold-over-clearance",
      by_clearance
          ? fmt::format("Four times the clearance, {:.2g} in place of {:.2g} mm: {} times as fast",
                        2 * clearance / millimetre, clearance / 2 / millimetre,
                        extent(by_clearance->least, by_clearance->most, "{:.2f}"))
          : "The fastest quiet speed over the clearance",
      "clearance [mm]", clearance, levers.over_clearance));
}

}  // namespace ricochet::studies::reproduction
