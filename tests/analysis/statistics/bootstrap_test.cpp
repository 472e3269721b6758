#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "src/analysis/statistics/intervals.h"

namespace ricochet {
namespace {

TEST(Bootstrap, InterpolatesQuantilesBetweenNeighbours) {
  const std::vector<double> sample = {4, 1, 3, 2};
  EXPECT_DOUBLE_EQ(quantile(sample, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile(sample, 1.0), 4.0);
}

TEST(Bootstrap, KeepsInfiniteValuesLast) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantile({1, infinity, 2}, 0.5), 2.0);
  EXPECT_EQ(quantile({1, infinity, infinity}, 0.5), infinity);
  EXPECT_EQ(quantile({infinity, infinity}, 0.3), infinity);
}

TEST(Bootstrap, OfARootMeanSquareHasTheQuantilesOfAllResamples) {
  // Of two errors 0 and 1 a sample has none, one or two of the second: 1/4, 1/2, 1/4.
  const std::vector<std::vector<double>> errors = {{0}, {-1}};
  EXPECT_DOUBLE_EQ(root_mean_square({3, -4}), std::sqrt(12.5));
  const Interval half = root_mean_square_interval(errors, 0.4, 10000, 1);
  EXPECT_DOUBLE_EQ(half.lower, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(half.upper, std::sqrt(0.5));
  const Interval all = root_mean_square_interval(errors, 0.95, 10000, 1);
  EXPECT_EQ(all.lower, 0);
  EXPECT_EQ(all.upper, 1);
  // Errors of a group come together: a quarter of the samples has only the first group.
  const Interval grouped = root_mean_square_interval({{0, 0}, {2, 2}}, 0.4, 10000, 1);
  EXPECT_DOUBLE_EQ(grouped.lower, std::sqrt(2));
  const Interval uneven = root_mean_square_interval({{0, 0, 0}, {2}}, 0.4, 10000, 1);
  EXPECT_DOUBLE_EQ(uneven.lower, 1);
}

}  // namespace
}  // namespace ricochet
