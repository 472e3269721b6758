#include "src/research/limits/grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "src/core/progress.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

std::size_t power(std::size_t base, std::size_t exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// The coordinates of a point by its index; the last axis changes first.
Vector place_of(std::size_t number, std::size_t axes, std::size_t steps) {
  Vector u(static_cast<Eigen::Index>(axes));
  for (Eigen::Index i = u.size(); i-- > 0; number /= steps) {
    u[i] = static_cast<double>(number % steps) / static_cast<double>(steps - 1);
  }
  return u;
}

}  // namespace

GridScan scanned_grid(const Fit& about, const std::vector<Unknown>& axes, int steps) {
  const Parameterisation parameterisation{about.interpretation, axes, about.constants};
  const auto size = static_cast<std::size_t>(steps);
  const std::size_t points = power(size, axes.size());
  std::vector<GoalValues> goals(points);
  Progress progress("an exhaustive scan", static_cast<double>(points));
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t k) {
    const Constants constants = constants_at(parameterisation, place_of(k, axes.size(), size));
    goals[k] = goals_of(judged_by_thresholds(about.interpretation, constants));
    progress.advance(1);
  });
  const auto best_by = [&](auto member) {
    const auto best = std::ranges::min_element(goals, {}, member);
    Fit fit = about;
    fit.constants =
        constants_at(parameterisation,
                     place_of(static_cast<std::size_t>(best - goals.begin()), axes.size(), size));
    fit.loss = (*best).*member;
    return fit;
  };
  GridScan scan{about,
                axes,
                steps,
                best_by(&GoalValues::threshold_error),
                best_by(&GoalValues::worst_threshold),
                0,
                0,
                0,
                0,
                {}};
  scan.threshold_error = scan.lowest_error.loss;
  scan.worst_threshold = scan.lowest_worst.loss;
  const GoalValues own = goals_of(judged_by_thresholds(about.interpretation, about.constants));
  scan.own_error = own.threshold_error;
  scan.own_worst = own.worst_threshold;
  const std::size_t beneath = points / (size * size);
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<double>& row = scan.map.emplace_back();
    for (std::size_t j = 0; j < size; ++j) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < beneath; ++k) {
        least = std::min(least, goals[(i * size + j) * beneath + k].threshold_error);
      }
      row.push_back(least);
    }
  }
  return scan;
}

}  // namespace ricochet::studies::limits
