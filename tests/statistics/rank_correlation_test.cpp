#include "src/statistics/rank_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ricochet {
namespace {

TEST(RankCorrelation, IsOneForAnyRisingRelationAndMinusOneForAFallingOne) {
  EXPECT_EQ(rank_correlation({1, 2, 3, 10}, {0.1, 0.2, 5, 6}), 1.0);
  EXPECT_EQ(rank_correlation({1, 2, 3, 10}, {6, 5, 0.2, 0.1}), -1.0);
}

TEST(RankCorrelation, IsWhatTheRanksByHandGive) {
  // Without ties 1 - 6 sum d^2 / (n (n^2 - 1)): d = 0, 1, -1, 0 of n = 4.
  EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 3, 4}, {1, 3, 2, 4}), 1 - 6 * 2.0 / (4 * 15));
  // Ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: 4.5 / sqrt(4.5 * 5).
  EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 2, 4}, {1, 2, 3, 4}), 4.5 / std::sqrt(4.5 * 5));
}

TEST(RankCorrelation, IsNothingWhereASampleIsConstant) {
  EXPECT_FALSE(rank_correlation({1, 1, 1}, {1, 2, 3}));
  EXPECT_FALSE(rank_correlation({1, 2, 3}, {7, 7, 7}));
}

TEST(RankCorrelation, RefusesSamplesThatDoNotFit) {
  EXPECT_THROW(rank_correlation({1, 2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(rank_correlation({1}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
