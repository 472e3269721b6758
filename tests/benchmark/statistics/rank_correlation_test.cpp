#include "src/benchmark/statistics/rank_correlation.h"

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

TEST(RankCorrelation, OfKendallIsWhatThePairsByHandGive) {
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {0.1, 0.2, 5, 6}), 1.0);
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {6, 5, 0.2, 0.1}), -1.0);
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 3, 2, 4}), (5.0 - 1) / 6);
  // Five pairs of six are untied in the first, all in the second.
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 3, 4}), 5 / std::sqrt(5.0 * 6));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 2, 2, 4}), 5 / std::sqrt(6 * 5.0));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 2, 4}), 1);
  EXPECT_FALSE(kendall_rank_correlation({1, 1, 1}, {1, 2, 3}));
}

TEST(RankCorrelation, OfKendallHasAnIntervalWithin1) {
  const Interval interval = kendall_interval(0.6, 20);
  // atanh(0.6) = log(2); Student's t of 18 degrees of freedom times the deviation.
  const double half = 2.100922 * std::sqrt(0.437 / 16);
  EXPECT_NEAR(std::atanh(interval.lower), std::log(2) - half, 1e-6);
  EXPECT_NEAR(std::atanh(interval.upper), std::log(2) + half, 1e-6);
  EXPECT_EQ(kendall_interval(1, 20).lower, 1);
  EXPECT_EQ(kendall_interval(-1, 20).upper, -1);
  EXPECT_THROW(kendall_interval(0.6, 4), std::invalid_argument);
  EXPECT_THROW(kendall_interval(1.1, 20), std::invalid_argument);
}

TEST(RankCorrelation, RefusesSamplesThatDoNotFit) {
  EXPECT_THROW(kendall_rank_correlation({1, 2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(rank_correlation({1, 2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(rank_correlation({1}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
