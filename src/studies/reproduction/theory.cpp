#include "src/studies/paper/theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>

#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;

using Points = std::vector<ThresholdPoint>;

/// Converts a mean error of ln w to a share of w.
Value share_of(const std::optional<double>& logarithm) {
  return value_of(logarithm, [](double x) { return std::expm1(x); });
}

/// The constants of a fitted formula: "c = 7.56, k = 1.45".
std::string told_constants(const Formula& formula, const FormulaFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < formula.constants.size(); ++k) {
    text +=
        fmt::format("{}{} = {:.3g}", k == 0 ? "" : ", ", formula.constants[k], fit.constants[k]);
  }
  return text;
}

}  // namespace

void add_theory(const std::vector<CaseStudy>& cases, report::Results& results) {
  Points paper, computed;
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    if (!it.claim.threshold) continue;
    paper.push_back({it.id, it.restitution, it.friction, it.disturbance, *it.claim.threshold});
    if (!c.score.threshold) continue;
    computed.push_back(paper.back());
    computed.back().threshold = *c.score.threshold;
  }
  Table table{"formulas",
              {{"formula"},
               {"constants", "fitted constants"},
               {"explained", "variance explained [%]", ".1%"},
               {"error", "error [%]", ".0%"},
               {"left_out", "error, left out [%]", ".0%"},
               {"computed_error", "error on the computed [%]", ".0%"},
               {"computed_left_out", "left out [%]", ".0%"}}};
  for (const Formula& formula : all_formulas()) {
    const auto fit = fitted(formula, paper), other = fitted(formula, computed);
    const auto rms = [](const FormulaFit& one) { return std::expm1(one.errors.rms); };
    const auto left_out = [](const FormulaFit& one) { return share_of(one.left_out); };
    table.add(formula.words,
              value_of(fit, [&](const FormulaFit& one) { return told_constants(formula, one); }),
              value_of(fit, [](const FormulaFit& one) { return one.errors.explained; }),
              value_of(fit, rms), value_of(fit, left_out), value_of(other, rms),
              value_of(other, left_out));
  }
  const auto row =
      table.find([](const Row& it) { return it.text("formula") == friction_formula().words; });
  for (const char* column : {"explained", "error", "left_out"})
    results.set(fmt::format("formula.{}", column), (*row)[column]);
  results.add(std::move(table));
}

namespace {

using Places = std::uint32_t;  // a set of them

bool has(Places set, std::size_t place) {
  return (set >> place & 1U) != 0;
}

double mean_of(const std::vector<double>& values, Places set) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += has(set, i) ? values[i] : 0;
  return sum / std::popcount(set);
}

double nearest_at(std::size_t i, const std::vector<double>& values,
                  const std::vector<Places>& upper_sets) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Places upper : upper_sets) {
    if (!has(upper, i)) continue;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Places other : upper_sets) {  // a lower set is the complement of an upper one
      if (!has(other, i)) lowest = std::min(lowest, mean_of(values, upper & ~other));
    }
    highest = std::max(highest, lowest);
  }
  return highest;
}

/// Returns true if the paper concludes that the threshold of `a` is at most that of `b`.
bool concluded(const Case& a, const Case& b) {
  if (a.restitution == b.restitution && a.friction == b.friction)
    return a.disturbance > b.disturbance;  // (C)
  if (a.disturbance != 0 || b.disturbance != 0) return false;
  if (a.friction == b.friction) return a.restitution > b.restitution;  // (A)
  return a.restitution == b.restitution && a.friction < b.friction;    // (B)
}

/// Returns true if two cases differ in nothing but the disturbance.
bool is_same_machine(const Case& a, const Case& b) {
  return a.restitution == b.restitution && a.friction == b.friction;
}

std::vector<AtMost> order_of(const std::vector<Case>& cases,
                             bool (*at_most)(const Case&, const Case&)) {
  std::vector<AtMost> order;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t j = 0; j < cases.size(); ++j)
      if (i != j && at_most(cases[i], cases[j])) order.push_back({i, j});
  }
  return order;
}

}  // namespace

OrderBound isotonic_bound(const std::vector<double>& values, const std::vector<AtMost>& order) {
  const std::size_t size = values.size();
  if (size < 1 || size > 16) throw std::invalid_argument("1 to 16 values");
  std::vector<Places> upper_sets;
  for (Places set = 0; set < Places{1} << size; ++set) {
    const bool is_upper = std::ranges::all_of(
        order, [&](const AtMost& o) { return !has(set, o.lower) || has(set, o.upper); });
    if (is_upper) upper_sets.push_back(set);
  }
  OrderBound bound{0, 0};
  double squares = 0;
  for (std::size_t i = 0; i < size; ++i) {
    bound.nearest.push_back(nearest_at(i, values, upper_sets));
    squares += std::pow(bound.nearest[i] - values[i], 2);
    Places above = ~Places{0};  // of all that must not be less than i
    for (const Places set : upper_sets)
      if (has(set, i)) above &= set;
    for (std::size_t j = 0; j < size; ++j)
      if (has(above, j)) bound.largest = std::max(bound.largest, (values[i] - values[j]) / 2);
  }
  bound.root_mean_square = std::sqrt(squares / static_cast<double>(size));
  return bound;
}

OrderBound concave_bound(const std::vector<double>& three, double share) {
  const double below = (1 - share) * three[0] + share * three[2] - three[1];
  if (below <= 0) return {0, 0};
  // The distance from a half-space: by the Euclidean length of its normal, and by the sum of the
  // magnitudes of its entries (the largest error if all are equal).
  const double square_of_normal = std::pow(1 - share, 2) + std::pow(share, 2) + 1;
  return {std::sqrt(below * below / square_of_normal / 3), below / 2};
}

void add_bounds(report::Results& results) {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return !c.claim.threshold; });
  const auto logs_of = [](const std::vector<Case>& some) {
    std::vector<double> logs;
    for (const Case& c : some) logs.push_back(std::log(*c.claim.threshold));
    return logs;
  };
  const std::vector<double> logs = logs_of(cases);
  OrderBound concave{0, 0};
  double squares = 0, share_of_fall = 0;
  std::string steepest;
  for (const Case& still : cases) {
    std::vector<Case> machine;
    std::ranges::copy_if(cases, std::back_inserter(machine),
                         [&](const Case& c) { return is_same_machine(c, still); });
    if (still.disturbance != 0 || machine.size() != 3) continue;
    std::ranges::sort(machine, {}, &Case::disturbance);
    const std::vector<double> three = logs_of(machine);
    const OrderBound own = concave_bound(three, machine[1].disturbance / machine[2].disturbance);
    squares += 3 * std::pow(own.root_mean_square, 2);
    if (own.largest <= concave.largest) continue;
    concave.largest = own.largest;
    steepest = still.id;
    share_of_fall = (three[0] - three[1]) / (three[0] - three[2]);
  }
  concave.root_mean_square = std::sqrt(squares / static_cast<double>(cases.size()));
  Table table{"bounds",
              {{"premise", "if the thresholds are"},
               {"largest", "worst threshold, at least [%]", ".1%"},
               {"root_mean_square", "root mean square, at least [%]", ".1%"}}};
  const auto add = [&](const char* premise, const OrderBound& bound) {
    table.add(premise, bound.largest, bound.root_mean_square);
  };
  add("in the order that the paper concludes", isotonic_bound(logs, order_of(cases, concluded)));
  add("falling in proportion to the disturbance, or more steeply", concave);
  add("the same whatever the disturbance", isotonic_bound(logs, order_of(cases, is_same_machine)));
  results.set("bound", table[0].number("largest"));
  results.set("steepest.case", steepest);
  results.set("steepest.share", share_of_fall);
  results.add(std::move(table));
}

}  // namespace ricochet::studies::reproduction
