#include "src/benchmark/statistics/attainment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace ricochet {
namespace {

void check(const History& history, const Levels& levels) {
  if (!(levels.lower < levels.upper))
    throw std::invalid_argument("levels: lower < upper is needed");
  check_history(history);
}

double reached(const Levels& levels, double value) {
  return (levels.upper - std::clamp(value, levels.lower, levels.upper)) /
         (levels.upper - levels.lower);
}

}  // namespace

void check_history(const History& history) {
  for (std::size_t i = 0; i < history.size(); ++i) {
    const bool fits = i == 0 ? history[i].evaluations >= 1 && !std::isnan(history[i].value)
                             : history[i].evaluations > history[i - 1].evaluations &&
                                   history[i].value < history[i - 1].value;
    if (!fits) throw std::invalid_argument("history: evaluations must rise and values fall");
  }
}

double attainment(const History& history, const Levels& levels, double t) {
  check(history, levels);
  double share = 0;
  for (const BestSoFar& best : history) {
    if (best.evaluations <= t) share = reached(levels, best.value);
  }
  return share;
}

double area_over_convergence_curve(const History& history, const Levels& levels, double budget,
                                   EvaluationAxis axis) {
  check(history, levels);
  if (!(budget >= 1)) throw std::invalid_argument("area_over_convergence_curve: budget < 1");
  // Evaluation t extends from t to t + 1 on the axis.
  const auto place = [&](double t) { return axis == EvaluationAxis::linear ? t - 1 : std::log(t); };
  const double end = place(budget + 1);
  double area = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double from = std::min(end, place(history[i].evaluations));
    const double to =
        i + 1 < history.size() ? std::min(end, place(history[i + 1].evaluations)) : end;
    area += reached(levels, history[i].value) * (to - from);
  }
  return area / end;
}

}  // namespace ricochet
