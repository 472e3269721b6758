#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/break_even.h"

namespace ricochet {
namespace {

TEST(ParetoFront, IsThatOfAllPairsCompared) {
  Random random(14);
  for (int i = 0; i < 100; ++i) {
    std::vector<CostAndError> points;
    for (int k = 0; k < 25; ++k) {
      points.push_back({std::floor(8 * uniform(random)), std::floor(8 * uniform(random))});
    }
    std::vector<std::size_t> front = pareto_front(points);
    EXPECT_TRUE(std::is_sorted(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
      return points[a].cost < points[b].cost;
    }));
    std::sort(front.begin(), front.end());
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CostAndError& own = points[k];
      const bool dominated =
          std::any_of(points.begin(), points.end(), [&](const CostAndError& other) {
            return other.cost <= own.cost && other.error <= own.error &&
                   (other.cost < own.cost || other.error < own.error);
          });
      if (!dominated) expected.push_back(k);
    }
    EXPECT_EQ(front, expected);
  }
}

TEST(ParetoFront, RefusesWhatIsNoNumber) {
  EXPECT_TRUE(pareto_front({}).empty());
  EXPECT_THROW(pareto_front({{1, std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
