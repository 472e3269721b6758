#include "src/analysis/statistics/intervals.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "ricochet/random.h"

namespace ricochet {

Interval wilson_interval(double successes, double trials, double confidence) {
  check_confidence(confidence);
  if (!(trials > 0 && successes >= 0 && successes <= trials)) {
    throw std::invalid_argument("wilson_interval: 0 <= successes <= trials and a trial are needed");
  }
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const double failures = trials - successes;
  const double centre = successes + z * z / 2;
  const double half = z * std::sqrt(successes * failures / trials + z * z / 4);
  // For no success or no failure one end is exactly 0 or 1, despite rounding.
  return {successes == 0 ? 0 : std::max(0.0, (centre - half) / (trials + z * z)),
          failures == 0 ? 1 : std::min(1.0, (centre + half) / (trials + z * z))};
}

MeanShare mean_share(const std::vector<double>& shares, double confidence) {
  constexpr double imagined = 0.1;
  if (shares.empty()) throw std::invalid_argument("mean_share: no values");
  const auto size = static_cast<double>(shares.size());
  double sum = 0;
  for (const double share : shares) {
    if (!(share >= 0 && share <= 1))
      throw std::invalid_argument("mean_share: a value not in [0, 1]");
    sum += share;
  }
  const double mean = std::min(1.0, sum / size);
  double squares = imagined * (mean * mean + (1 - mean) * (1 - mean));
  for (const double share : shares) squares += (share - mean) * (share - mean);
  const double variance = squares / (size - 1 + imagined);
  // Values in [0, 1] vary most if all of them are 0 or 1.
  const double trials = std::max(size, size * mean * (1 - mean) / variance);
  return {mean, wilson_interval(mean * trials, trials, confidence)};
}

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

double root_mean_square(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

Interval root_mean_square_interval(const std::vector<std::vector<double>>& groups,
                                   double confidence, int resamples, std::uint64_t seed) {
  Random random(seed);
  const auto size = static_cast<double>(groups.size());
  std::vector<double> means;
  std::vector<double> drawn;
  for (int k = 0; k < resamples; ++k) {
    drawn.clear();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const auto& group = groups[static_cast<std::size_t>(size * uniform(random))];
      drawn.insert(drawn.end(), group.begin(), group.end());
    }
    means.push_back(root_mean_square(drawn));
  }
  return {quantile(means, (1 - confidence) / 2), quantile(means, (1 + confidence) / 2)};
}

}  // namespace ricochet
