#include "src/contest/ceiling.h"

#include <tbb/parallel_for.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace ricochet::contest {

std::optional<Ceiling> ceiling(const Question& question, double width) {
  const Problem& stated = question.stated;
  if (stated.dimension() != 1 || !stated.smoothed || !stated.best_point) return std::nullopt;
  const Problem smooth = stated.smoothed(width);
  const double lower = stated.lower[0];
  const double upper = stated.upper[0];
  // What is infeasible by however little is worse than all that is feasible.
  const auto shown = [&](double x) {
    const Truth truth = truth_of(smooth.evaluate(Vector::Constant(1, x)), stated.equalities);
    return truth.violation > 0 ? std::numeric_limits<double>::max() : truth.objective;
  };
  const auto cells =
      static_cast<std::size_t>(std::ceil((upper - lower) / (10 * question.scan_step)));
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
  Ceiling result{optimum, std::abs(optimum - (*stated.best_point)[0]), std::nullopt};
  const Truth truth = truth_at(stated, Vector::Constant(1, optimum));
  if (truth.violation <= 0 && stated.best_known)
    result.regret = truth.objective - *stated.best_known;
  return result;
}

}  // namespace ricochet::contest
