#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/attainment.h"
#include "tests/core/infinity.h"

namespace ricochet {
namespace {

const Costs costs = {
    {1, 2, 4},
    {3, 3, infinity},
    {infinity, 5, 10},
    {infinity, infinity, infinity},
};

TEST(PerformanceProfile, HasTheRatiosAndSharesComputedByHand) {
  const Costs ratios = performance_ratios(costs);
  EXPECT_EQ(ratios,
            (Costs{{1, 2, 4}, {1, 1, infinity}, {infinity, 1, 2}, {infinity, infinity, infinity}}));
  EXPECT_EQ(performance_profile(ratios, 1, 1).mean, 0.5);
  EXPECT_EQ(performance_profile(ratios, 1, 2).mean, 0.75);
  EXPECT_EQ(performance_profile(ratios, 1, infinity).mean, 0.75);
  EXPECT_EQ(performance_profile(ratios, 2, 1).mean, 0);
  EXPECT_EQ(performance_profile(ratios, 2, 3.9).mean, 0.25);
  EXPECT_EQ(performance_profile(ratios, 2, 4).mean, 0.5);
}

TEST(PerformanceProfile, ExtendedShowsByHowMuchTheWinnerWins) {
  EXPECT_EQ(
      extended_performance_ratios(costs),
      (Costs{{0.5, 2, 4}, {1, 1, infinity}, {infinity, 0.5, 2}, {infinity, infinity, infinity}}));
  EXPECT_EQ(extended_performance_ratios({{7, infinity}}), (Costs{{0, infinity}}));
}

TEST(PerformanceProfile, OfTwoMayBeReversedByAThird) {
  const Costs three = {{1, 2, 8}, {1, 8, 3}, {1, 8, 3}};  // as Gould and Scott warn
  const Costs with = performance_ratios(three);
  EXPECT_GT(performance_profile(with, 1, 2).mean, performance_profile(with, 2, 2).mean);
  const Costs without = performance_ratios(costs_of_pair(three, 1, 2));
  EXPECT_LT(performance_profile(without, 0, 2).mean, performance_profile(without, 1, 2).mean);
}

TEST(PerformanceProfile, RisesFromWinsToSolvedProblemsAndIsTheExtendedOneFrom1On) {
  Random random(11);
  for (int i = 0; i < 30; ++i) {
    Costs drawn(20, std::vector<double>(4));
    for (auto& row : drawn) {
      for (double& cost : row)
        cost = uniform(random) < 0.3 ? infinity : 1 + std::floor(9 * uniform(random));
    }
    const Costs ratios = performance_ratios(drawn);
    const Costs extended = extended_performance_ratios(drawn);
    for (std::size_t s = 0; s < 4; ++s) {
      double solved = 0;
      for (const auto& row : drawn) solved += std::isfinite(row[s]) ? 1 : 0;
      EXPECT_DOUBLE_EQ(performance_profile(ratios, s, 9).mean, solved / 20);
      double before = 0;
      for (double ratio = 1; ratio < 10; ratio += 0.25) {
        const double share = performance_profile(ratios, s, ratio).mean;
        EXPECT_GE(share, before);
        EXPECT_EQ(share, performance_profile(extended, s, ratio).mean);
        before = share;
      }
    }
  }
}

TEST(PerformanceProfile, RefusesWhatDoesNotFit) {
  EXPECT_THROW(performance_ratios({}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{0, 2}}), std::invalid_argument);
  EXPECT_THROW(performance_ratios({{std::nan(""), 2}}), std::invalid_argument);
  EXPECT_THROW(extended_performance_ratios({{1}}), std::invalid_argument);
  EXPECT_THROW(performance_profile({{1, 2}}, 2, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({}, 0, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({{-1}}, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
