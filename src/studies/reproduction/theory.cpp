#include "src/studies/reproduction/theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

#include "src/studies/paper/theory.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Mark;

using Points = std::vector<ThresholdPoint>;

/// The thresholds of one origin, and their name in the report.
struct Thresholds {
  std::string name;
  Points points;
};

/// The paper's thresholds, and the computed ones of the same cases.
std::vector<Thresholds> thresholds_of(const std::vector<CaseStudy>& cases) {
  Thresholds paper{"paper", {}};
  Thresholds computed{"computed", {}};
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    if (!it.claim.threshold) continue;
    ThresholdPoint point{it.id, it.restitution, it.friction, it.disturbance, *it.claim.threshold};
    paper.points.push_back(point);
    if (!c.score.threshold) continue;
    point.threshold = *c.score.threshold;
    computed.points.push_back(point);
  }
  return {paper, computed};
}

/// Converts a mean error of ln w to a share of w.
std::optional<double> share_of(const std::optional<double>& logarithm) {
  return logarithm ? std::optional(std::expm1(*logarithm)) : std::nullopt;
}

/// The constants of a formula that was fitted to the paper, "c = 7.56, k = 1.45".
std::string told_constants(const Formula& formula, const FormulaFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < formula.constants.size(); ++k) {
    text +=
        fmt::format("{}{} = {:.3g}", k == 0 ? "" : ", ", formula.constants[k], fit.constants[k]);
  }
  return text;
}

/// A row for each formula, fitted to the paper's thresholds and to the computed ones.
Table formula_table(const std::vector<Thresholds>& both) {
  Table table{"formulas",
              {{"formula"},
               {"constants", "fitted constants"},
               {"explained", "variance explained [%]", ".1%"},
               {"error", "error [%]", ".0%"},
               {"left_out", "error, left out [%]", ".0%"},
               {"computed_error", "error on the computed [%]", ".0%"},
               {"computed_left_out", "left out [%]", ".0%"}}};
  for (const Formula& formula : all_formulas()) {
    std::vector<Value> row = {formula.words};
    for (const Thresholds& one : both) {
      const auto fit = fitted(formula, one.points);
      if (one.name == "paper") {
        row.push_back(fit ? value_of(told_constants(formula, *fit)) : Value());
        row.push_back(fit ? value_of(fit->errors.explained) : Value());
      }
      row.push_back(fit ? value_of(share_of(fit->errors.rms)) : Value());
      row.push_back(fit ? value_of(share_of(fit->left_out)) : Value());
    }
    table.add_row(std::move(row));
  }
  return table;
}

double root_of_loss(double restitution) {
  return std::sqrt((1 - restitution) / (1 + restitution));
}

/// The thresholds over the formula's root, where every power law is a straight line.
report::Chart formula_chart(const std::vector<Thresholds>& both) {
  report::Chart chart{.name = "theory",
                      .title = "",
                      .x = {.label = "√((1 − e) / (1 + e))",
                            .scale = report::Scale::logarithmic,
                            .range = report::Range{0.2, 1}},
                      .y = {.label = "threshold [rad/s]", .scale = report::Scale::logarithmic},
                      .width = 780,
                      .height = 460};
  std::vector<report::Series> lines;
  for (const Thresholds& one : both) {
    std::set<double> frictions;
    for (const ThresholdPoint& point : one.points) frictions.insert(point.friction);
    for (const double friction : frictions) {
      report::Series group{fmt::format("{}, friction {}", one.name, friction), Mark::points, {}};
      for (const ThresholdPoint& point : one.points) {
        if (point.friction == friction)
          group.samples.push_back({root_of_loss(point.restitution), point.threshold});
      }
      std::ranges::stable_sort(group.samples, {}, &report::Sample::position);
      chart.series.push_back(std::move(group));
    }
    const auto fit = fitted(square_root_formula(), one.points);
    if (!fit) continue;
    const double c = fit->constants[0];
    lines.push_back({fmt::format("{}, {:.1f} √((1 − e) / (1 + e))", one.name, c),
                     Mark::line,
                     {{0.2, 0.2 * c}, {1, c}}});
    if (one.name == "paper" && fit->errors.explained)
      chart.title = fmt::format(
          "c √((1 − e) / (1 + e)) explains {:.0f} % of the variance of the paper's thresholds",
          100 * *fit->errors.explained);
  }
  chart.series.insert(chart.series.end(), lines.begin(), lines.end());
  return chart;
}

/// Thresholds of cases that differ in one property alone: the ratios of those with the larger value
/// to those with the smaller one.
std::vector<double> ratios_of(const Points& points, double ThresholdPoint::*differs,
                              const std::function<bool(const ThresholdPoint&)>& fits) {
  std::vector<double> ratios;
  for (const ThresholdPoint& from : points) {
    for (const ThresholdPoint& to : points) {
      ThresholdPoint same = from;
      same.*differs = to.*differs;
      const bool pair = from.*differs < to.*differs && same.restitution == to.restitution &&
                        same.friction == to.friction && same.disturbance == to.disturbance;
      if (pair && fits(from)) ratios.push_back(to.threshold / from.threshold);
    }
  }
  return ratios;
}

/// "3.65 to 4.50"; nothing for none.
std::optional<std::string> extent_of(const std::vector<double>& ratios) {
  if (ratios.empty()) return {};
  const auto [least, most] = std::ranges::minmax(ratios);
  const std::string first = fmt::format("{:.2f}", least), last = fmt::format("{:.2f}", most);
  return first == last ? first : first + " to " + last;
}

/// By which factors the threshold rises from high restitution to low, and from low friction to
/// high.
Table factor_table(const std::vector<Thresholds>& both) {
  Table table{"factors", {{"change"}, {"paper"}, {"computed"}, {"formula", "", ".2f"}}};
  const auto fit = fitted(friction_formula(), both[0].points);
  const auto by_friction =
      fit ? std::optional(std::exp(fit->constants[1] * (0.4 - 0.1))) : std::nullopt;
  const auto slower = [](const Points& points) {
    std::vector<double> ratios =
        ratios_of(points, &ThresholdPoint::restitution, [](const ThresholdPoint&) { return true; });
    for (double& ratio : ratios) ratio = 1 / ratio;
    return extent_of(ratios);
  };
  table.add("restitution from 0.9 to 0.1", slower(both[0].points), slower(both[1].points),
            root_of_loss(0.1) / root_of_loss(0.9));
  for (const double restitution : {0.1, 0.9}) {
    const auto of = [&](const Points& points) {
      return extent_of(ratios_of(points, &ThresholdPoint::friction, [&](const ThresholdPoint& p) {
        return p.restitution == restitution;
      }));
    };
    table.add(fmt::format("friction from 0.1 to 0.4, at restitution {}", restitution),
              of(both[0].points), of(both[1].points), by_friction);
  }
  return table;
}

}  // namespace

void add_theory(const std::vector<CaseStudy>& cases, report::Results& results) {
  const std::vector<Thresholds> both = thresholds_of(cases);
  results.add(formula_table(both));
  results.add(factor_table(both));
  results.add(formula_chart(both));
  const auto fit = fitted(friction_formula(), both[0].points);
  results.set("formula.explained", fit ? fit->errors.explained : std::nullopt);
  results.set("formula.error", fit ? share_of(fit->errors.rms) : std::nullopt);
  results.set("formula.left_out", fit ? share_of(fit->left_out) : std::nullopt);
}

namespace {

using Places = std::uint32_t;  // a set of them

bool has(Places set, std::size_t place) {
  return (set >> place & 1U) != 0;
}

/// Returns true if everything above a member is a member.
bool is_upper(Places set, const std::vector<AtMost>& order) {
  return std::all_of(order.begin(), order.end(),
                     [&](const AtMost& o) { return !has(set, o.lower) || has(set, o.upper); });
}

double mean_of(const std::vector<double>& values, Places set) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += has(set, i) ? values[i] : 0;
  return sum / std::popcount(set);
}

double nearest_at(std::size_t i, const std::vector<double>& values,
                  const std::vector<Places>& upper_sets) {
  const Places all = (Places{1} << values.size()) - 1;
  double highest = -std::numeric_limits<double>::infinity();
  for (const Places upper : upper_sets) {
    if (!has(upper, i)) continue;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Places other : upper_sets) {  // a lower set is the complement of an upper one
      const Places lower = all & ~other;
      if (has(lower, i)) lowest = std::min(lowest, mean_of(values, upper & lower));
    }
    highest = std::max(highest, lowest);
  }
  return highest;
}

/// Transitive closure: true if the order implies that the first is at most the second.
std::vector<std::vector<bool>> closure(std::size_t size, const std::vector<AtMost>& order) {
  std::vector<std::vector<bool>> at_most(size, std::vector<bool>(size, false));
  for (const AtMost& o : order) at_most[o.lower][o.upper] = true;
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        if (at_most[i][k] && at_most[k][j]) at_most[i][j] = true;
      }
    }
  }
  return at_most;
}

/// Returns true if the paper concludes that the threshold of `a` is at most that of `b`.
bool concluded(const Case& a, const Case& b) {
  if (a.restitution == b.restitution && a.friction == b.friction) {
    return a.disturbance > b.disturbance;  // (C)
  }
  if (a.disturbance != 0 || b.disturbance != 0) return false;
  if (a.friction == b.friction) return a.restitution > b.restitution;  // (A)
  return a.restitution == b.restitution && a.friction < b.friction;    // (B)
}

}  // namespace

OrderBound isotonic_bound(const std::vector<double>& values, const std::vector<AtMost>& order) {
  if (values.empty() || values.size() > 16) throw std::invalid_argument("1 to 16 values");
  std::vector<Places> upper_sets;
  for (Places set = 0; set < Places{1} << values.size(); ++set) {
    if (is_upper(set, order)) upper_sets.push_back(set);
  }
  OrderBound bound{0, 0, {}};
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    bound.nearest.push_back(nearest_at(i, values, upper_sets));
    squares += std::pow(bound.nearest[i] - values[i], 2);
  }
  bound.root_mean_square = std::sqrt(squares / static_cast<double>(values.size()));
  const auto at_most = closure(values.size(), order);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (at_most[i][j]) bound.largest = std::max(bound.largest, (values[i] - values[j]) / 2);
    }
  }
  return bound;
}

std::vector<AtMost> concluded_order(const std::vector<Case>& cases) {
  std::vector<AtMost> order;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t j = 0; j < cases.size(); ++j) {
      if (concluded(cases[i], cases[j])) order.push_back({i, j});
    }
  }
  return order;
}

std::vector<AtMost> indifferent_order(const std::vector<Case>& cases) {
  std::vector<AtMost> order;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t j = 0; j < cases.size(); ++j) {
      const bool same =
          cases[i].restitution == cases[j].restitution && cases[i].friction == cases[j].friction;
      if (same && i != j) order.push_back({i, j});
    }
  }
  return order;
}

std::vector<Response> responses(const std::vector<Case>& cases) {
  std::vector<Response> all;
  for (const Case& first : cases) {
    if (first.disturbance != 0) continue;
    Response response{{}, 0, 0};
    for (const Case& c : cases) {
      if (c.restitution == first.restitution && c.friction == first.friction) {
        response.cases.push_back(c);
      }
    }
    if (response.cases.size() != 3) continue;
    std::ranges::sort(response.cases, {}, &Case::disturbance);
    const std::vector<double> y = log_thresholds(response.cases);
    const double share = response.cases[1].disturbance / response.cases[2].disturbance;
    response.first_share = (y[0] - y[1]) / (y[0] - y[2]);
    response.below_chord = (1 - share) * y[0] + share * y[2] - y[1];
    all.push_back(std::move(response));
  }
  return all;
}

OrderBound proportional_bound(const std::vector<Response>& all, std::size_t thresholds) {
  OrderBound bound{0, 0, {}};
  double squares = 0;
  for (const Response& r : all) {
    if (r.below_chord <= 0) continue;
    const double share = r.cases[1].disturbance / r.cases[2].disturbance;
    // The distance from a half-space: by the Euclidean length of its normal, and by the sum of the
    // magnitudes of its entries (the largest error if all are equal).
    const double square_of_normal = std::pow(1 - share, 2) + std::pow(share, 2) + 1;
    squares += std::pow(r.below_chord, 2) / square_of_normal;
    bound.largest = std::max(bound.largest, r.below_chord / 2);
  }
  bound.root_mean_square = std::sqrt(squares / static_cast<double>(thresholds));
  return bound;
}

std::vector<Case> cases_with_threshold() {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return !c.claim.threshold; });
  return cases;
}

std::vector<double> log_thresholds(const std::vector<Case>& cases) {
  std::vector<double> logs;
  for (const Case& c : cases) logs.push_back(std::log(*c.claim.threshold));
  return logs;
}

void add_bounds(report::Results& results) {
  const std::vector<Case> cases = cases_with_threshold();
  const std::vector<double> logs = log_thresholds(cases);
  const std::vector<Response> all = responses(cases);
  const Response& steepest = *std::ranges::max_element(all, {}, &Response::below_chord);
  Table table{"bounds",
              {{"premise", "if the thresholds are"},
               {"largest", "worst threshold, at least [%]", ".1%"},
               {"root_mean_square", "root mean square, at least [%]", ".1%"}}};
  const auto add = [&](const char* premise, const OrderBound& bound) {
    table.add(premise, bound.largest, bound.root_mean_square);
  };
  add("in the order that the paper concludes", isotonic_bound(logs, concluded_order(cases)));
  add("falling in proportion to the disturbance, or more steeply",
      proportional_bound(all, cases.size()));
  add("the same whatever the disturbance", isotonic_bound(logs, indifferent_order(cases)));
  results.set("bound", table[0].number("largest"));
  results.set("steepest.case", steepest.cases.front().id);
  results.set("steepest.share", steepest.first_share);
  results.add(std::move(table));
}

}  // namespace ricochet::studies::reproduction
