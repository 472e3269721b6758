#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "src/analysis/statistics/profiles.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

TEST(EmpiricalDistribution, IsTheShareOfPairsReached) {
  const std::vector<std::vector<double>> times = {{1, 5, infinity}, {5, 7, 9}};
  EXPECT_EQ(empirical_distribution(times, 0.5).mean, 0);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 1).mean, 1.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, 5).mean, 3.0 / 6);
  EXPECT_DOUBLE_EQ(empirical_distribution(times, infinity).mean, 5.0 / 6) << "never is never";
}

TEST(EmpiricalDistribution, WeighsProblemsAlike) {
  EXPECT_DOUBLE_EQ(empirical_distribution({{1, 1, 1, 1}, {2}}, 1).mean, 0.5);
}

TEST(EmpiricalDistribution, IsNoMoreCertainForMoreOfTheSamePairs) {
  const Interval once = empirical_distribution({{1}, {3}, {1}, {1}, {3}}, 2).interval;
  const Interval thrice =
      empirical_distribution({{1, 1, 1}, {3, 3, 3}, {1, 1, 1}, {1, 1, 1}, {3, 3, 3}}, 2).interval;
  EXPECT_EQ(once.lower, thrice.lower);
  EXPECT_EQ(once.upper, thrice.upper);
}

TEST(EmpiricalDistribution, RefusesWhatDoesNotFit) {
  EXPECT_THROW(empirical_distribution({{}}, 1), std::invalid_argument);
  EXPECT_THROW(empirical_distribution({}, 1), std::invalid_argument);
  EXPECT_THROW(empirical_distribution({{std::nan("")}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
