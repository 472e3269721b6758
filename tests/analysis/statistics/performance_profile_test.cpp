#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/profiles.h"
#include "tests/support/numbers.h"

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
  EXPECT_EQ(performance_profile(ratios, 1, 1), 0.5);
  EXPECT_EQ(performance_profile(ratios, 1, 2), 0.75);
  EXPECT_EQ(performance_profile(ratios, 1, infinity), 0.75);
  EXPECT_EQ(performance_profile(ratios, 2, 1), 0);
  EXPECT_EQ(performance_profile(ratios, 2, 3.9), 0.25);
  EXPECT_EQ(performance_profile(ratios, 2, 4), 0.5);
}

TEST(PerformanceProfile, OfTwoMayBeReversedByAThird) {
  const Costs three = {{1, 2, 8}, {1, 8, 3}, {1, 8, 3}};  // as Gould and Scott warn
  const Costs with = performance_ratios(three);
  EXPECT_GT(performance_profile(with, 1, 2), performance_profile(with, 2, 2));
  const Costs without = performance_ratios({{2, 8}, {8, 3}, {8, 3}});
  EXPECT_LT(performance_profile(without, 0, 2), performance_profile(without, 1, 2));
}

TEST(PerformanceProfile, RisesFromWinsToSolvedProblems) {
  Random random(11);
  for (int i = 0; i < 30; ++i) {
    Costs drawn(20, std::vector<double>(4));
    for (auto& row : drawn) {
      for (double& cost : row)
        cost = uniform(random) < 0.3 ? infinity : 1 + std::floor(9 * uniform(random));
    }
    const Costs ratios = performance_ratios(drawn);
    for (std::size_t s = 0; s < 4; ++s) {
      double solved = 0;
      for (const auto& row : drawn) solved += std::isfinite(row[s]) ? 1 : 0;
      EXPECT_DOUBLE_EQ(performance_profile(ratios, s, 9), solved / 20);
      double before = 0;
      for (double ratio = 1; ratio < 10; ratio += 0.25) {
        const double share = performance_profile(ratios, s, ratio);
        EXPECT_GE(share, before);
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
  EXPECT_THROW(performance_profile({{1, 2}}, 2, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({}, 0, 1), std::invalid_argument);
  EXPECT_THROW(performance_profile({{-1}}, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
