#include "problems/carrier_track/suite/best_known.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "embedded/best_known_text.h"
#include "ricochet/error.h"
#include "ricochet/run.h"
#include "src/core/instance.h"
#include "src/core/toml.h"

namespace ricochet::carrier_track::inline problems {

namespace {

BestKnown best_of(const toml::table& table, const InputError& error) {
  const auto value = table["value"].value<double>();
  const auto provenance = table["provenance"].value<std::string>();
  const toml::array* point = table["point"].as_array();
  if (!value || !provenance || point == nullptr) throw error;
  BestKnown best{*value, Vector(static_cast<Eigen::Index>(point->size())), *provenance};
  for (Eigen::Index i = 0; i < best.point.size(); ++i) {
    const auto coordinate = point->get(static_cast<std::size_t>(i))->value<double>();
    if (!coordinate) throw error;
    best.point[i] = *coordinate;
  }
  return best;
}

}  // namespace

BestValues parse_best_values(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  const auto suite = file["suite"].value<int>();
  if (suite != suite_version) {
    throw InputError(
        fmt::format("{}: best values of version {} of the suite; this is version {}: "
                    "search them again by ricochet best-values",
                    origin, suite.value_or(1), suite_version));
  }
  const auto machine = file["machine"].value<std::string>();
  if (!machine) throw InputError(origin + ": machine must be there, as a text");
  BestValues values{*machine, {}};
  for (const auto& [key, node] : file) {
    if (key.str() == "suite" || key.str() == "machine") continue;
    const InputError error(
        fmt::format("{}: {}: must be a table of value, point and provenance", origin, key.str()));
    const toml::table* table = node.as_table();
    if (table == nullptr) throw error;
    values.of.emplace(key.str(), best_of(*table, error));
  }
  return values;
}

std::string write_best_values(const BestValues& values) {
  std::string text = fmt::format(
      "# The best values known, from `ricochet best-values`.\nsuite = {}\nmachine = \"{}\"\n",
      suite_version, values.machine);
  for (const auto& [name, best] : values.of) {
    std::string point;
    for (const double x : best.point) {
      point += fmt::format("{}{}", point.empty() ? "" : ", ", toml_float(x));
    }
    text += fmt::format("\n[{}]\nvalue = {}\npoint = [{}]\nprovenance = \"{}\"\n", name,
                        toml_float(best.value), point, best.provenance);
  }
  return text;
}

const BestValues& best_values() {
  static const BestValues values =
      parse_best_values(embedded::best_known_text, "problems/carrier_track/suite/best_known.toml");
  return values;
}

void know_best(Problem& problem, const std::string& machine) {
  if (machine.empty() || machine != best_values().machine) return;
  const auto found = best_values().of.find(problem.name);
  if (found == best_values().of.end()) return;
  problem = knowing(std::move(problem), found->second);
}

Problem knowing(Problem problem, const BestKnown& best) {
  problem.best_known = best.value;
  problem.best_point = best.point;
  problem.provenance = best.provenance;
  if (problem.smoothed) {
    problem.smoothed = [smoothed = std::move(problem.smoothed), best](double smoothing) {
      return knowing(smoothed(smoothing), best);
    };
  }
  return problem;
}

namespace {

constexpr double bisected_to = 1e-7;
constexpr int neighbours = 10;

std::string by_scan(double step) {
  return fmt::format("exhaustive scan, step {}, then bisection", step);
}

}  // Of equal points the first one wins, not the start.

BestKnown scan_for_best(const Problem& problem, double step) {
  const auto true_values = [&](double x) {
    return true_values_at(problem, Vector::Constant(1, x));
  };
  const auto first = std::llround(std::ceil(problem.lower[0] / step - 1e-9));
  const auto last = std::llround(std::floor(problem.upper[0] / step + 1e-9));
  double best = problem.start[0];
  TrueValues best_true_values = true_values(best);
  for (auto k = first; k <= last; ++k) {
    const double x = std::clamp(static_cast<double>(k) * step, problem.lower[0], problem.upper[0]);
    const TrueValues found = true_values(x);
    // The start must not win over the first of equals.
    if (k == first || better(found, best_true_values)) {
      best = x;
      best_true_values = found;
    }
  }
  const auto bisect = [&] {
    for (const double side : {-step, step}) {
      double other = std::clamp(best + side, problem.lower[0], problem.upper[0]);
      while (std::abs(other - best) > bisected_to) {
        const double middle = (best + other) / 2;
        const TrueValues found = true_values(middle);
        const bool gains = better(found, best_true_values);
        (gains ? best : other) = middle;
        if (gains) best_true_values = found;
      }
    }
  };
  // Bisection ends between two points of the scan: points a step away from there may lie in quiet
  // intervals that the scan missed.
  for (bool moved = true; moved;) {
    bisect();
    moved = false;
    const double from = best;
    for (int k = -neighbours; k <= neighbours; ++k) {
      const double x = from + k * step;
      if (k == 0 || x < problem.lower[0] || x > problem.upper[0]) continue;
      const TrueValues found = true_values(x);
      if (!better(found, best_true_values)) continue;
      best = x;
      best_true_values = found;
      moved = true;
    }
  }
  if (best_true_values.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), by_scan(step)};
  }
  return {best_true_values.objective, Vector::Constant(1, best), by_scan(step)};
}

Findings scanned_best(const Problem& problem) {
  if (problem.dimension() != 1) {
    throw std::invalid_argument(
        fmt::format("{}: {} variables: must be one for a scan", problem.name, problem.dimension()));
  }
  const BestKnown best = scan_for_best(problem, problem.scan_step);
  return best.point.size() == 0 ? Findings() : Findings{{"best_point", best.point[0]}};
}

Problem with_scanned_best(Problem problem, const Findings& found) {
  const Vector point = Vector::Constant(1, found.at("best_point"));
  const double value = true_values_at(problem, point).objective;
  const std::string provenance = by_scan(problem.scan_step);
  return knowing(std::move(problem), {value, point, provenance});
}

}  // namespace ricochet::carrier_track::inline problems
