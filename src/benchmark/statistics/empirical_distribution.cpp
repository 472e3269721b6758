#include "src/benchmark/statistics/empirical_distribution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet {

MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 double confidence) {
  std::vector<double> shares;
  for (const std::vector<double>& times : hitting_times) {
    if (times.empty() ||
        std::any_of(times.begin(), times.end(), [](double x) { return std::isnan(x); })) {
      throw std::invalid_argument("empirical_distribution: a problem has no times, or not numbers");
    }
    const auto reached = std::count_if(times.begin(), times.end(),
                                       [&](double x) { return x <= t && !std::isinf(x); });
    shares.push_back(static_cast<double>(reached) / static_cast<double>(times.size()));
  }
  return mean_share(shares, confidence);
}

}  // namespace ricochet
