#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/progress.h"
#include "src/studies/machine/charts.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Chart;
using report::Mark;
using report::Series;

/// [m/s], between which the effect of the counting limit is told: nobody measured it.
constexpr double low_limit = 1e-3, high_limit = 10e-3;
constexpr const char* speed_label = "fastest quiet speed [rad/s]";

/// The fastest quiet speed of a machine over one of its constants.
struct Curve {
  std::string label;
  std::vector<double> values;  ///< rising, in SI units
  std::function<Scene(double value)> machine;
};

/// Computes all points of the curves. Nothing where every speed up to the highest is quiet, or none
/// is. Parallel.
std::vector<Series> solved(const std::vector<Curve>& curves, double unit, double highest,
                           const char* what) {
  std::vector<Series> all;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (const Curve& curve : curves) {
    all.push_back({curve.label, Mark::line, {}});
    for (const double value : curve.values) {
      places.emplace_back(all.size() - 1, all.back().samples.size());
      all.back().samples.push_back({value / unit, {}});
    }
  }
  Progress progress(what, static_cast<double>(places.size()));
  tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
    const auto [k, place] = places[i];
    const Scene scene = curves[k].machine(curves[k].values[place]);
    if (has_regimes(scene)) {
      const auto speed = quiet_up_to(scene, quiet_per_turn, {slowest_speed, highest});
      if (speed && *speed < highest) all[k].samples[place].value = speed;
    }
    progress.advance(1);
  });
  return all;
}

std::optional<double> speed_at(const Series& series, double position) {
  const auto found = std::ranges::find(series.samples, position, &report::Sample::position);
  return found == series.samples.end() ? std::nullopt : found->value;
}

/// "1.5 to 5.0 times": by how much the curves rise between two positions. Empty if none has both.
std::string times(const std::vector<Series>& curves, double from, double to) {
  std::optional<double> least, most;
  for (const Series& series : curves) {
    const auto first = speed_at(series, from), last = speed_at(series, to);
    if (!first || !last) continue;
    least = std::min(least.value_or(*last / *first), *last / *first);
    most = std::max(most.value_or(*last / *first), *last / *first);
  }
  return least ? fmt::format("{:.1f} to {:.1f} times", *least, *most) : "";
}

/// Over restitutions from 0.05 to 0.95 for the frictions of the cases and the least and the largest
/// of their disturbances, with the paper's cases as points. A threshold takes longer under a
/// disturbance, so such curves have fewer points, and there are none if the curves are `coarse`.
Chart restitution_chart(const std::vector<CaseStudy>& cases, const Scene& interpretation,
                        bool coarse, double highest) {
  std::set<double> frictions, disturbances;
  Series paper{.label = "paper", .mark = Mark::points, .samples = {}, .dark = true};
  for (const CaseStudy& c : cases) {
    frictions.insert(c.the_case.friction);
    disturbances.insert(c.the_case.disturbance);
    const auto threshold = c.the_case.claim.threshold;
    if (threshold) paper.samples.push_back({c.the_case.restitution, threshold, {}, c.the_case.id});
  }
  std::vector<double> many;  // from thousandths, so that those of the cases are met exactly
  for (int thousandths = 50; thousandths <= 950; thousandths += coarse ? 50 : 25)
    many.push_back(thousandths / 1000.0);
  const std::vector<double> few = {0.05, 0.075, 0.1, 0.15, 0.2, 0.3, 0.4,
                                   0.5,  0.6,   0.7, 0.8,  0.9, 0.95};
  std::vector<Curve> curves;
  for (const double friction : frictions) {
    for (const double disturbance : {*disturbances.begin(), *disturbances.rbegin()}) {
      if (coarse && disturbance > 0) continue;
      curves.push_back(
          {fmt::format("friction {}, disturbance {} N", friction, disturbance),
           disturbance > 0 ? few : many, [=](double restitution) {
             return scene_of({"", restitution, friction, disturbance, {}}, interpretation);
           }});
    }
  }
  Chart chart{.name = "threshold-over-restitution",
              .title = "",
              .x = {.label = "restitution", .range = report::Range{0, 1}},
              .y = {.label = speed_label, .scale = report::Scale::logarithmic},
              .series = solved(curves, 1, highest, "thresholds over restitution"),
              .width = 720,
              .height = 400};
  chart.title = fmt::format("Restitution 0.1 in place of 0.9 lets the machine turn {} as fast",
                            times(chart.series, 0.9, 0.1));
  chart.series.push_back(std::move(paper));
  return chart;
}

/// Of the cases without disturbance, on logarithmic axes, where an exponent is a slope.
Chart limit_chart(const std::vector<CaseStudy>& cases, double own, bool coarse, double highest) {
  std::set<double> values = {low_limit, 3e-3, own, high_limit};
  const int number = coarse ? 9 : 25;
  for (int k = 0; k < number; ++k) values.insert(0.5e-3 * std::pow(40.0, k / (number - 1.0)));
  std::vector<Curve> curves;
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    if (it.disturbance != 0) continue;
    curves.push_back(
        {fmt::format("{}: restitution {}, friction {}", it.id, it.restitution, it.friction),
         {values.begin(), values.end()},
         [scene = c.scene](double limit) {
           Scene other = scene;
           other.counting_limit = limit;
           return other;
         }});
  }
  Chart chart{.name = "threshold-over-counting-limit",
              .title = "",
              .x = {.label = "counting limit [mm/s]", .scale = report::Scale::logarithmic},
              .y = {.label = speed_label, .scale = report::Scale::logarithmic},
              .series = solved(curves, millimetre, highest, "thresholds over the counting limit"),
              .lines = {{report::Direction::vertical, own / millimetre, "fitted"}}};
  chart.title = fmt::format("A counting limit of {:.2g} in place of {:.2g} mm/s: {} as fast",
                            high_limit / millimetre, low_limit / millimetre,
                            times(chart.series, low_limit / millimetre, high_limit / millimetre));
  return chart;
}

/// The exponents of a case, by constant.
struct CaseExponents {
  std::string id;
  std::vector<Sensitivity> exponents;  ///< the largest first
};

std::vector<CaseExponents> exponents_of(const std::vector<CaseStudy>& cases) {
  std::vector<CaseExponents> all;
  for (const CaseStudy& c : cases) {
    if (c.the_case.disturbance != 0 || !c.borders.quiet) continue;
    const Limit limit{Measure::collisions_per_turn, quiet_per_turn};
    all.push_back({c.the_case.id, sensitivities(c.scene, limit, *c.borders.quiet)});
  }
  return all;
}

std::string in_words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

/// A row for each constant that moves the speed, a column for each case; the largest first.
Table exponents_table(const std::vector<CaseExponents>& all,
                      const FittedInterpretation& interpretation) {
  Table table{"exponents", {{"constant"}, {"known"}}};
  std::vector<std::string> keys;
  for (const CaseExponents& one : all) {
    table.columns.push_back({one.id, one.id, "+.2f"});
    for (const Sensitivity& s : one.exponents)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  }
  std::vector<std::string> shown;
  for (const Column& column : table.columns) shown.push_back(column.name);
  table.columns.push_back({"largest"});
  for (const std::string& key : keys) {
    const bool fitted = std::ranges::any_of(interpretation.free, [&](Unknown free) {
      return unknown_parameters()[static_cast<std::size_t>(free)].name == key;
    });
    const bool given = key == "restitution" || key == "friction";
    std::vector<Value> row = {in_words(key), given ? "the paper's" : fitted ? "fitted" : "fixed"};
    double largest = 0;
    for (const CaseExponents& one : all) {
      const auto found = std::ranges::find(one.exponents, key, &Sensitivity::key);
      row.push_back(found == one.exponents.end() ? Value() : value_of(found->percent));
      largest = std::max(largest, std::abs(number_in(row.back()).value_or(0)));
    }
    row.emplace_back(largest);
    if (largest >= 0.005) table.add_row(std::move(row));
  }
  return only(sorted(std::move(table), {"-largest"}), shown);
}

/// What moves the first case: "restitution -0.84 %, counting limit +0.82 %", as far as it can be
/// seen, and its speeds over the counting limit.
std::string told(const CaseExponents& first, const Series& over_limit, double own) {
  std::string text, limits, speeds;
  for (const Sensitivity& s : first.exponents) {
    if (std::abs(s.percent) < 0.005) continue;
    text += fmt::format("{}{} {:+.2f} %", text.empty() ? "" : ", ", in_words(s.key), s.percent);
  }
  for (const double limit : {low_limit, 3e-3, own, high_limit}) {
    const auto speed = speed_at(over_limit, limit / millimetre);
    if (!speed) continue;
    const char* between = limits.empty() ? "" : limit == high_limit ? " and " : ", ";
    limits += fmt::format("{}{:.3g}", between, limit / millimetre);
    speeds += fmt::format("{}{:.2f}", between, *speed);
  }
  return fmt::format(
      "One per cent more of a constant moves the fastest quiet speed of {} by: {}. The counting "
      "limit, the speed from which an impact counts as a collision, is fitted to the paper's "
      "thresholds and not measured. With limits of {} mm/s {} is quiet up to {} rad/s.",
      first.id, text, limits, first.id, speeds);
}

}  // namespace

void add_levers(const std::vector<CaseStudy>& cases, const FittedInterpretation& interpretation,
                bool coarse, double highest, report::Results& results) {
  const std::vector<CaseExponents> exponents = exponents_of(cases);
  const double own = interpretation.scene.counting_limit;
  Chart by_limit = limit_chart(cases, own, coarse, highest);
  results.set("moves", exponents.empty()
                           ? std::nullopt
                           : std::optional(told(exponents.front(), by_limit.series.front(), own)));
  results.add(exponents_table(exponents, interpretation));
  results.add(std::move(by_limit));
  results.add(restitution_chart(cases, interpretation.scene, coarse, highest));
}

}  // namespace ricochet::studies::reproduction
