#include "src/benchmark/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ricochet/random.h"

namespace ricochet {

double quantile(std::vector<double> sample, double q) {
  const double place = q * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  const auto at_low = sample.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(sample.begin(), at_low, sample.end());
  const double low = *at_low;
  if (share == 0.0) return low;
  const double high = *std::min_element(at_low + 1, sample.end());
  return std::isinf(high) ? high : low + share * (high - low);
}

Interval median_interval(const std::vector<double>& sample, double confidence, int resamples,
                         std::uint64_t seed) {
  Random random(seed);
  const auto size = static_cast<double>(sample.size());
  std::vector<double> medians;
  std::vector<double> drawn(sample.size());
  for (int i = 0; i < resamples; ++i) {
    for (double& x : drawn) x = sample[static_cast<std::size_t>(size * uniform(random))];
    medians.push_back(quantile(drawn, 0.5));
  }
  return {quantile(medians, (1 - confidence) / 2), quantile(medians, (1 + confidence) / 2)};
}

}  // namespace ricochet
