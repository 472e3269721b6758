#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/analysis/statistics/running_time.h"

namespace ricochet {
namespace {

TEST(ShiftedGeometricMean, IsWhatIsComputedByHand) {
  EXPECT_NEAR(shifted_geometric_mean({10, 100}), std::sqrt(20.0 * 110) - 10, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean({0.1, 0}), 1, 1e-12);  // both on the floor
  EXPECT_NEAR(shifted_geometric_mean({2, 8}, 0, 1), 4, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean({2, 8}, 1e9, 0), 5, 1e-5);  // the arithmetic mean at last
  EXPECT_TRUE(std::isinf(shifted_geometric_mean({2, std::numeric_limits<double>::infinity()})));
}

TEST(ShiftedGeometricMean, RefusesWhatDoesNotFit) {
  EXPECT_THROW(shifted_geometric_mean({}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({-1}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({std::nan("")}), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({1}, 0, 0), std::invalid_argument);
  EXPECT_THROW(shifted_geometric_mean({1}, -1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
