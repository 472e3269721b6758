#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "src/analysis/statistics/break_even.h"
#include "tests/core/infinity.h"

namespace ricochet {
namespace {

TEST(VirtualBest, IsTheLeastOfEachProblem) {
  EXPECT_EQ(virtual_best({{3, 2}, {infinity, 7}, {infinity, infinity}}),
            (std::vector<double>{2, 7, infinity}));
}

TEST(VirtualBest, IsAheadOfTheSingleBestByWhatIsComputedByHand) {
  const VirtualBestGap gap = virtual_best_gap({{10, 90, 50}, {490, 40, 50}});
  EXPECT_EQ(gap.single_best, 2U);  // 60 < sqrt(100 * 50) < sqrt(20 * 500)
  EXPECT_NEAR(gap.mean_of_single_best, 50, 1e-9);
  EXPECT_NEAR(gap.mean_of_virtual_best, std::sqrt(20.0 * 50) - 10, 1e-9);
}

TEST(VirtualBest, IsNoBetterThanOneSolverAlone) {
  const VirtualBestGap gap = virtual_best_gap({{10}, {40}});
  EXPECT_DOUBLE_EQ(gap.mean_of_single_best, gap.mean_of_virtual_best);
  EXPECT_THROW(virtual_best({}), std::invalid_argument);
  EXPECT_THROW(virtual_best_gap({{1, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
