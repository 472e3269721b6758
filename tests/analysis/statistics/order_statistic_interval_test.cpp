#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "src/analysis/statistics/intervals.h"
#include "tests/core/infinity.h"

namespace ricochet {
namespace {

std::vector<double> up_to(int size) {
  std::vector<double> sample(static_cast<std::size_t>(size));
  std::iota(sample.rbegin(), sample.rend(), 1.0);
  return sample;
}

TEST(OrderStatisticInterval, HasThePublishedRanksForTheMedian) {
  struct Ranks {
    int size;
    double lower, upper;
  };
  // As in the tables of, for example, Conover 1999, section 3.2; below 6 there are none.
  for (const auto& [size, lower, upper] : {Ranks{6, 1, 6},
                                           {10, 2, 9},
                                           {15, 4, 12},
                                           {20, 6, 15},
                                           {25, 8, 18},
                                           {30, 10, 21},
                                           {50, 18, 33}}) {
    const auto interval = order_statistic_interval(up_to(size));
    ASSERT_TRUE(interval) << size;
    EXPECT_EQ(interval->lower, lower) << size;
    EXPECT_EQ(interval->upper, upper) << size;
  }
  EXPECT_FALSE(order_statistic_interval(up_to(5)));
  EXPECT_FALSE(order_statistic_interval({}));
}

/// P(B < count) of `size` tosses that fall below with chance q, by Pascal's rule.
double chance_of_less(int count, int size, double q) {
  std::vector<double> chance = {1};
  for (int toss = 0; toss < size; ++toss) {
    std::vector<double> next(chance.size() + 1);
    for (std::size_t k = 0; k < chance.size(); ++k) {
      next[k] += (1 - q) * chance[k];
      next[k + 1] += q * chance[k];
    }
    chance = next;
  }
  return std::accumulate(chance.begin(), chance.begin() + count, 0.0);
}

TEST(OrderStatisticInterval, CoversAtLeastAsOftenAsItSaysAndEndsAtTheNearestRanks) {
  for (const double q : {0.1, 0.5, 0.8}) {
    for (const double confidence : {0.5, 0.9, 0.95}) {
      const double tail = (1 - confidence) / 2 + 1e-12;
      for (int size = 1; size <= 40; ++size) {
        const auto interval = order_statistic_interval(up_to(size), q, confidence);
        if (!interval) {
          EXPECT_GT(std::max(std::pow(1 - q, size), std::pow(q, size)), tail);
          continue;
        }
        const auto lower = static_cast<int>(interval->lower);
        const auto upper = static_cast<int>(interval->upper);
        EXPECT_LE(chance_of_less(lower, size, q), tail);
        EXPECT_GT(chance_of_less(lower + 1, size, q), tail);
        EXPECT_LE(1 - chance_of_less(upper, size, q), tail);
        EXPECT_GT(1 - chance_of_less(upper - 1, size, q), tail);
      }
    }
  }
}

TEST(OrderStatisticInterval, TakesWhatWasNeverReachedForTheLargest) {
  std::vector<double> sample = up_to(15);
  for (double& x : sample) x = x > 11 ? infinity : x;
  EXPECT_EQ(order_statistic_interval(sample)->lower, 4);
  EXPECT_EQ(order_statistic_interval(sample)->upper, infinity);
  EXPECT_EQ(order_statistic_interval(std::vector<double>(15, infinity))->lower, infinity);
}

TEST(OrderStatisticInterval, RefusesWhatDoesNotFit) {
  EXPECT_THROW(order_statistic_interval({1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(order_statistic_interval({1, 2}, 1.0), std::invalid_argument);
  EXPECT_THROW(order_statistic_interval({1, 2}, 0.5, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
