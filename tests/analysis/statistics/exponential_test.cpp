#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {
namespace {

TEST(Exponential, HasItsDistributionEverywhere) {
  const Exponential exponential;
  Random random(16);
  constexpr int size = 200000;
  std::vector<double> drawn(size);
  for (double& x : drawn) x = exponential(random);
  std::sort(drawn.begin(), drawn.end());
  double distance = 0;  // Kolmogorov's
  for (int i = 0; i < size; ++i) {
    const double expected = -std::expm1(-drawn[static_cast<std::size_t>(i)]);
    distance = std::max(distance, std::abs((i + 0.5) / size - expected));
  }
  EXPECT_LT(distance, 1.95 / std::sqrt(size));  // exceeded once in a thousand seeds
  const double beyond =
      static_cast<double>(drawn.end() - std::upper_bound(drawn.begin(), drawn.end(), 8.0));
  EXPECT_NEAR(beyond, size * std::exp(-8.0), 4 * std::sqrt(size * std::exp(-8.0)));
  EXPECT_GT(drawn.front(), 0);
}

}  // namespace
}  // namespace ricochet
