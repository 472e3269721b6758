#include "problems/carrier_track/problems/scanned_best.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ricochet/verdict.h"

namespace ricochet::carrier_track::inline problems {
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
