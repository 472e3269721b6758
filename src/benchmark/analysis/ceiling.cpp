#include "src/benchmark/analysis/ceiling.h"

#include <tbb/parallel_for.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace ricochet::comparison {

std::optional<Ceiling> ceiling(const Problem& problem, double smoothing) {
  if (problem.dimension() != 1 || !problem.smoothed || !problem.best_point) return std::nullopt;
  const Problem smooth = problem.smoothed(smoothing);
  const double lower = problem.lower[0];
  const double upper = problem.upper[0];
  // Any infeasible point is worse than every feasible one.
  const auto shown = [&](double x) {
    const TrueValues true_values =
        true_values_of(smooth.evaluate(Vector::Constant(1, x)), problem.equalities);
    return true_values.violation > 0 ? std::numeric_limits<double>::max() : true_values.objective;
  };
  const auto cells =
      static_cast<std::size_t>(std::ceil((upper - lower) / (10 * problem.scan_step)));
  std::vector<double> values(cells + 1);
  const auto at = [&](std::size_t k) {
    return lower + (upper - lower) * static_cast<double>(k) / static_cast<double>(cells);
  };
  tbb::parallel_for(std::size_t{0}, values.size(),
                    [&](std::size_t k) { values[k] = shown(at(k)); });
  const auto best =
      static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
  constexpr int bits = 20;
  const auto [refined, value] = boost::math::tools::brent_find_minima(
      shown, at(best == 0 ? 0 : best - 1), at(std::min(best + 1, cells)), bits);
  const double optimum = value < values[best] ? refined : at(best);
  Ceiling result{optimum, std::abs(optimum - (*problem.best_point)[0]), std::nullopt};
  const TrueValues true_values = true_values_at(problem, Vector::Constant(1, optimum));
  if (true_values.violation <= 0 && problem.best_known)
    result.optimality_gap = true_values.objective - *problem.best_known;
  return result;
}

}  // namespace ricochet::comparison
