#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>

#include "ricochet/random.h"
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

TEST(Bootstrap, CoversTheTrueMedianAboutAsOftenAsItSays) {
  Random random(7);
  int covered = 0;
  constexpr int trials = 400;
  for (int i = 0; i < trials; ++i) {
    const Vector drawn = normal(25, random).array() + 3.0;
    const std::vector<double> sample(drawn.begin(), drawn.end());
    const Interval interval = median_interval(sample, 0.95, 300, static_cast<std::uint64_t>(i));
    covered += interval.lower <= 3.0 && 3.0 <= interval.upper ? 1 : 0;
  }
  EXPECT_GT(covered, 0.90 * trials);
  EXPECT_LT(covered, 0.995 * trials);
}

TEST(Bootstrap, HasTheQuantilesOfAllResamples) {
  // The median of 11 draws is at most k where at least 6 are, each with chance k / 11.
  const auto exact = [](double q) {
    double k = 1;
    while (cdf(complement(boost::math::binomial(11, k / 11), 5)) < q) ++k;
    return k;
  };
  const std::vector<double> sample = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  for (const double confidence : {0.5, 0.8, 0.95, 0.9999}) {
    const Interval interval = median_interval(sample, confidence, 100000, 3);
    EXPECT_EQ(interval.lower, exact((1 - confidence) / 2)) << confidence;
    EXPECT_EQ(interval.upper, exact((1 + confidence) / 2)) << confidence;
  }
}

TEST(Bootstrap, GivesTheSameIntervalForTheSameSeed) {
  const std::vector<double> sample = {1, 5, 2, 8, 3, 9, 4};
  const Interval a = median_interval(sample, 0.95, 100, 1);
  const Interval b = median_interval(sample, 0.95, 100, 1);
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
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
