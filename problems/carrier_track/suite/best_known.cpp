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
#include "src/core/toml_fields.h"

namespace ricochet::carrier_track::inline problems {

template <class Visit, IsOf<BestKnown>... B>
void visit_fields(const Visit& visit, B&... b) {
  using enum Presence;
  visit(Field{"value", "1", "", {}, required}, b.value...);
  visit(Field{"point", "1", "", {}, required}, b.point...);
  visit(Field{"provenance", "", "", {}, required}, b.provenance...);
}

namespace {

/// A file of best values.
struct BestValuesFile {
  int suite = 1;
  BestValues values;
};

template <class Visit, IsOf<BestValuesFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  visit(Field{"suite", "1", "", whole_number(1)}, f.suite...);
  visit(Field{"machine", "", "", {}, Presence::required}, f.values.machine...);
  visit(Field{other_keys}, f.values.of...);
}

}  // namespace

BestValues parse_best_values(const std::string& text, const std::string& origin) {
  const toml::table table = parse_toml(text, origin);
  const auto suite = table["suite"].value<int>();
  if (suite != suite_version) {
    throw InputError(
        fmt::format("{}: best values of version {} of the suite; this is version {}: "
                    "search them again by ricochet best-values",
                    origin, suite.value_or(1), suite_version));
  }
  return fields_from<BestValuesFile>(TomlTable(&table, origin)).values;
}

std::string write_best_values(const BestValues& values) {
  return "# The best values known, from `ricochet best-values`.\n" +
         toml_of_fields(BestValuesFile{suite_version, values});
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
