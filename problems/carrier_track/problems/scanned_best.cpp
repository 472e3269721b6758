#include "problems/carrier_track/questions/scanned_best.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/core/verdict.h"

namespace ricochet::carrier_track::inline questions {
namespace {

constexpr double bisected_to = 1e-7;
constexpr int neighbours = 10;

}  // namespace

BestKnown scan_for_best(const Problem& problem, double step) {
  const auto truth = [&](double x) { return truth_at(problem, Vector::Constant(1, x)); };
  const auto first = std::llround(std::ceil(problem.lower[0] / step - 1e-9));
  const auto last = std::llround(std::floor(problem.upper[0] / step + 1e-9));
  double best = problem.start[0];
  Truth best_truth = truth(best);
  for (auto k = first; k <= last; ++k) {
    const double x = std::clamp(static_cast<double>(k) * step, problem.lower[0], problem.upper[0]);
    const Truth found = truth(x);
    // The start must not win over the first of equals.
    if (k == first || better(found, best_truth)) {
      best = x;
      best_truth = found;
    }
  }
  const auto bisect = [&] {
    for (const double side : {-step, step}) {
      double other = std::clamp(best + side, problem.lower[0], problem.upper[0]);
      while (std::abs(other - best) > bisected_to) {
        const double middle = (best + other) / 2;
        const Truth found = truth(middle);
        const bool gains = better(found, best_truth);
        (gains ? best : other) = middle;
        if (gains) best_truth = found;
      }
    }
  };
  // Bisection ends between two places of the scan: those a step apart from there may lie in
  // pockets that the scan has stepped over.
  for (bool moved = true; moved;) {
    bisect();
    moved = false;
    const double from = best;
    for (int k = -neighbours; k <= neighbours; ++k) {
      const double x = from + k * step;
      if (k == 0 || x < problem.lower[0] || x > problem.upper[0]) continue;
      const Truth found = truth(x);
      if (!better(found, best_truth)) continue;
      best = x;
      best_truth = found;
      moved = true;
    }
  }
  std::string provenance = fmt::format("exhaustive scan, step {}, then bisection", step);
  if (best_truth.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), std::move(provenance)};
  }
  return {best_truth.objective, Vector::Constant(1, best), std::move(provenance)};
}

Question with_scanned_best(Question question) {
  if (question.stated.dimension() != 1) {
    throw std::invalid_argument(fmt::format("{}: {} variables: must be one for a scan",
                                            question.name(), question.stated.dimension()));
  }
  const BestKnown best = scan_for_best(question.stated, question.scan_step);
  if (best.point.size() == 0) return question;
  question.stated = knowing(std::move(question.stated), best);
  return question;
}

}  // namespace ricochet::carrier_track::inline questions
