#include "src/research/reproduction/order_bound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>

#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

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
  const std::vector<Response> all = responses(cases);
  const auto row = [](const char* premise, const OrderBound& bound) -> report::Json {
    return {{"premise", premise},
            {"largest", std::expm1(bound.largest)},
            {"root_mean_square", std::expm1(bound.root_mean_square)}};
  };
  report::Json steepest = report::list_of(all, [](const Response& r) -> report::Json {
    return {{"first", r.cases.front().id}, {"first_share", r.first_share}};
  });
  std::ranges::sort(steepest, std::greater(), [](const auto& r) { return r["first_share"]; });
  return {
      {"rows",
       {row("in the order that the paper concludes", isotonic_bound(logs, concluded_order(cases))),
        row("falling in proportion to the disturbance, or more steeply",
            proportional_bound(all, cases.size())),
        row("the same whatever the disturbance", isotonic_bound(logs, indifferent_order(cases)))}},
      {"steepest", steepest.front()}};
}

}  // namespace ricochet::studies::reproduction
