#include "src/studies/reproduction/theory_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

#include "src/studies/paper/theory.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

namespace {

using namespace carrier_track;
using report::Json;

using Points = std::vector<ThresholdPoint>;
using SceneSpeed = std::optional<double> (*)(const Scene&);

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

const CaseStudy& study_of(const ThresholdPoint& point, const std::vector<CaseStudy>& cases) {
  return *std::find_if(cases.begin(), cases.end(),
                       [&](const CaseStudy& c) { return c.the_case.id == point.id; });
}

/// Converts a mean error of ln w to a share of w.
Json share_of(const std::optional<double>& logarithm) {
  return logarithm ? Json(std::expm1(*logarithm)) : Json();
}

/// A row of the table; without errors if nothing is fitted or predicted.
Json row_of(const std::string& words, const std::string& thresholds, std::size_t fitted_constants,
            const std::optional<PredictionErrors>& errors) {
  return {{"formula", words},
          {"thresholds", thresholds},
          {"fitted", fitted_constants},
          {"constants", nullptr},
          {"explained", errors ? Json(errors->explained) : Json()},
          {"error", errors ? share_of(errors->rms) : Json()},
          {"left_out", nullptr},
          {"worst", errors ? share_of(errors->worst) : Json()},
          {"worst_id", errors ? Json(errors->worst_id) : Json()},
          {"missing", nullptr}};
}

Json row_of(const Formula& formula, const Thresholds& thresholds) {
  const auto fit = fitted(formula, thresholds.points);
  Json row = row_of(formula.words, thresholds.name, formula.constants.size(),
                    fit ? std::optional(fit->errors) : std::nullopt);
  if (!fit) return row;
  row["constants"] = Json::array();
  for (std::size_t k = 0; k < formula.constants.size(); ++k) {
    row["constants"].push_back({{"name", formula.constants[k]}, {"value", fit->constants[k]}});
  }
  row["left_out"] = share_of(fit->left_out);
  return row;
}

/// A speed from theory for the scene of every case, without fitted parameters.
Json row_of(const std::string& words, SceneSpeed speed, const std::vector<CaseStudy>& cases,
            const Thresholds& thresholds) {
  Points points;
  std::vector<double> predicted;
  for (const ThresholdPoint& point : thresholds.points) {
    const auto value = speed(study_of(point, cases).scene);
    if (!value) continue;
    points.push_back(point);
    predicted.push_back(*value);
  }
  Json row = row_of(words, thresholds.name, 0,
                    points.empty() ? std::nullopt : std::optional(errors_of(points, predicted)));
  const std::size_t all = thresholds.points.size();
  if (points.size() < all) row["missing"] = {{"cases", points.size()}, {"of", all}};
  return row;
}

Json table_of(const std::vector<CaseStudy>& cases, const std::vector<Thresholds>& both) {
  Json rows = Json::array();
  for (const Formula& formula : all_formulas()) {
    for (const Thresholds& one : both) rows.push_back(row_of(formula, one));
  }
  for (const Thresholds& one : both) {
    rows.push_back(row_of("sustained bouncing", sustained_bouncing_speed, cases, one));
  }
  for (const Thresholds& one : both) {
    rows.push_back(row_of("lift-off", lift_off_speed, cases, one));
  }
  return rows;
}

double root_of_loss(double restitution) {
  return std::sqrt((1 - restitution) / (1 + restitution));
}

/// The thresholds of one origin with one friction.
Json group_of(const Thresholds& one, double friction) {
  Json points = Json::array();
  for (const ThresholdPoint& point : one.points) {
    if (point.friction != friction) continue;
    points.push_back(
        {{"root_of_loss", root_of_loss(point.restitution)}, {"threshold", point.threshold}});
  }
  return {{"name", one.name}, {"friction", friction}, {"points", std::move(points)}};
}

/// Data of the chart: the thresholds by friction, and the formula's curve.
void add_curves(const std::vector<Thresholds>& both, Json& data) {
  data["groups"] = data["lines"] = Json::array();
  for (const Thresholds& one : both) {
    std::set<double> frictions;
    for (const ThresholdPoint& point : one.points) frictions.insert(point.friction);
    for (const double friction : frictions) data["groups"].push_back(group_of(one, friction));
    const auto fit = fitted(square_root_formula(), one.points);
    if (!fit) continue;
    const double c = fit->constants[0];
    data["lines"].push_back({{"name", one.name}, {"at_1", c}, {"at_0_2", 0.2 * c}});
  }
}

/// Two cases that differ only in one property.
struct Pair {
  ThresholdPoint from, to;
  double ratio() const { return to.threshold / from.threshold; }
};

/// Pairs whose property `differs` is larger in `to` and whose other two are equal.
std::vector<Pair> pairs_of(const Points& points, double ThresholdPoint::*differs) {
  std::vector<Pair> pairs;
  for (const ThresholdPoint& from : points) {
    for (const ThresholdPoint& to : points) {
      if (!(from.*differs < to.*differs)) continue;
      ThresholdPoint same = from;
      same.*differs = to.*differs;
      if (same.restitution == to.restitution && same.friction == to.friction &&
          same.disturbance == to.disturbance) {
        pairs.push_back({from, to});
      }
    }
  }
  return pairs;
}

/// From the smallest value to the largest, and whether they differ in two digits; null if there are
/// none.
Json range_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {{"least", *least},
          {"most", *most},
          {"varies", std::round(100 * *least) != std::round(100 * *most)}};
}

/// Ratio of the thresholds at the lower and the higher restitution.
Json restitution_factors(const Points& points) {
  std::vector<double> factors;
  for (const Pair& pair : pairs_of(points, &ThresholdPoint::restitution)) {
    factors.push_back(1 / pair.ratio());
  }
  return range_of(factors);
}

/// Factor by which friction multiplies the threshold, at restitution 0.1 and at 0.9.
Json friction_factors(const Points& points) {
  std::vector<double> low, high;
  for (const Pair& pair : pairs_of(points, &ThresholdPoint::friction)) {
    if (pair.from.restitution == 0.1) low.push_back(pair.ratio());
    if (pair.from.restitution == 0.9) high.push_back(pair.ratio());
  }
  return {{"low", range_of(low)}, {"high", range_of(high)}};
}

/// Data of the text on the thresholds of one origin.
Json data_of(const Thresholds& one) {
  const auto power = fitted(power_formula(), one.points);
  return {{"name", one.name},
          {"is_paper", one.name == "paper"},
          {"square_root", row_of(square_root_formula(), one)},
          {"with_friction", row_of(friction_formula(), one)},
          {"exponent", power ? Json(power->constants[1]) : Json()},
          {"restitution", restitution_factors(one.points)},
          {"friction", friction_factors(one.points)}};
}

/// Factor by which friction increases the speed of sustained bouncing; null if the scenes have none
/// at either restitution.
Json bouncing_friction(const std::vector<CaseStudy>& cases) {
  Points points;
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    const auto speed = sustained_bouncing_speed(c.scene);
    if (speed && it.claim.threshold) {
      points.push_back({it.id, it.restitution, it.friction, it.disturbance, *speed});
    }
  }
  const Json factors = friction_factors(points);
  return factors.at("low").is_null() || factors.at("high").is_null() ? Json() : factors;
}

/// Compares the computed thresholds with a speed of the model, at both restitutions, and finds at
/// which of them they agree within a tenth; null if the model has no such speed.
Json speed_data(const std::string& name, SceneSpeed speed, const std::vector<CaseStudy>& cases,
                const Points& computed) {
  Json ratios = Json::object();
  for (const auto& [key, restitution] : {std::pair{"low", 0.1}, std::pair{"high", 0.9}}) {
    std::vector<double> values;
    for (const ThresholdPoint& point : computed) {
      if (point.restitution != restitution) continue;
      const auto value = speed(study_of(point, cases).scene);
      if (value) values.push_back(point.threshold / *value);
    }
    if (values.empty()) return {{"name", name}, {"ratios", nullptr}};
    ratios[key] = range_of(values);
    ratios[key]["is_it"] = std::all_of(values.begin(), values.end(),
                                       [](double ratio) { return std::abs(ratio - 1) < 0.1; });
  }
  return {{"name", name}, {"ratios", std::move(ratios)}};
}

/// Height of the carrier in sustained bouncing, in clearances, and whether it has enough room.
Json height_data(const std::vector<CaseStudy>& cases) {
  std::vector<double> heights;
  for (const CaseStudy& c : cases) {
    const auto height = sustained_bouncing_height(c.scene);
    if (height) heights.push_back(*height / (c.scene.wall_upper - c.scene.wall_lower));
  }
  if (heights.empty()) return {};
  Json data = range_of(heights);
  data["fits"] = data["most"] < 1;
  data["fits_in_some"] = data["least"] < 1;
  return data;
}

}  // namespace

Json theory_data(const std::vector<CaseStudy>& cases) {
  const std::vector<Thresholds> both = thresholds_of(cases);
  const Points& computed = both[1].points;
  Json data = {{"thresholds", {data_of(both[0]), data_of(both[1])}},
               {"predicted_factor", root_of_loss(0.1) / root_of_loss(0.9)},
               {"bouncing_friction", bouncing_friction(cases)},
               {"speeds",
                {speed_data("lift-off", lift_off_speed, cases, computed),
                 speed_data("sustained bouncing", sustained_bouncing_speed, cases, computed)}},
               {"height", height_data(cases)},
               {"formulas", table_of(cases, both)}};
  add_curves(both, data);
  return data;
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

report::Json bound_data() {
  const std::vector<Case> cases = cases_with_threshold();
  const std::vector<double> logs = log_thresholds(cases);
  std::vector<Response> all = responses(cases);
  std::ranges::sort(all, std::greater(), &Response::below_chord);
  const auto row = [](const char* premise, const OrderBound& bound) -> report::Json {
    return {{"premise", premise},
            {"largest", bound.largest},
            {"root_mean_square", bound.root_mean_square}};
  };
  report::Json steepest = report::list_of(all, [](const Response& r) -> report::Json {
    return {{"first", r.cases.front().id}, {"first_share", r.first_share}};
  });
  return {
      {"rows",
       {row("in the order that the paper concludes", isotonic_bound(logs, concluded_order(cases))),
        row("falling in proportion to the disturbance, or more steeply",
            proportional_bound(all, cases.size())),
        row("the same whatever the disturbance", isotonic_bound(logs, indifferent_order(cases)))}},
      {"steepest", steepest.front()}};
}

}  // namespace ricochet::studies::reproduction
