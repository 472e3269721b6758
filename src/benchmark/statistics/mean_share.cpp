#include "src/benchmark/statistics/mean_share.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/benchmark/statistics/wilson_interval.h"

namespace ricochet {

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

}  // namespace ricochet
