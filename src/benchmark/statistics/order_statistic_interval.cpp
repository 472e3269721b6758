#include "src/benchmark/statistics/order_statistic_interval.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <stdexcept>

#include "src/benchmark/statistics/confidence.h"

namespace ricochet {

std::optional<Interval> order_statistic_interval(std::vector<double> sample, double q,
                                                 double confidence) {
  check_confidence(confidence);
  if (!(q > 0 && q < 1)) {
    throw std::invalid_argument("order_statistic_interval: the quantile must be in (0, 1)");
  }
  if (std::any_of(sample.begin(), sample.end(), [](double x) { return std::isnan(x); })) {
    throw std::invalid_argument("order_statistic_interval: a value is not a number");
  }
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  const double tail = (1 - confidence) / 2 * (1 + 1e-12);  // a tolerance for rounding
  const boost::math::binomial below(static_cast<double>(sample.size()), q);
  // With probability `tail` at most, the number of values below the quantile is less than `lower`;
  // the same holds for `upper` or more. Both count from 1.
  std::size_t lower = 0;
  while (lower < sample.size() && cdf(below, static_cast<double>(lower)) <= tail) ++lower;
  std::size_t upper = sample.size() + 1;
  while (upper > 1 && cdf(complement(below, static_cast<double>(upper) - 2)) <= tail) --upper;
  if (lower == 0 || upper > sample.size()) return std::nullopt;
  return Interval{sample[lower - 1], sample[upper - 1]};
}

}  // namespace ricochet
