#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/attainment.h"
#include "src/analysis/statistics/intervals.h"

namespace ricochet {
namespace {

const RunsOfUnits by_hand = {{{{1, 10}, {5, 3}}}, {{{2, 4}}}};
const AttainmentGrid grid_by_hand = {{1, 2, 5}, {3, 4, 10}};

TEST(AttainmentFunction, HasTheSharesComputedByHand) {
  const double expected[3][3] = {{0, 0, 0.5}, {0, 0.5, 1}, {0.5, 1, 1}};
  const auto attained = attainment_function(by_hand, grid_by_hand);
  ASSERT_EQ(attained.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(attained[i].size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(attained[i][k].share, expected[i][k]) << i << ' ' << k;
    }
  }
}

TEST(AttainmentFunction, HasTheIntervalOfSharesOfUnitsThatAllWeighTheSame) {
  const RunsOfUnits unequal = {{{{1, 3}}, {{1, 3}}, {{1, 5}}}, {{{1, 9}}}};
  const Attained attained = attainment_function(unequal, {{1}, {3}})[0][0];
  const MeanShare share = mean_share({2.0 / 3, 0});
  EXPECT_DOUBLE_EQ(attained.share, 1.0 / 3);
  EXPECT_EQ(attained.interval.lower, share.interval.lower);
  EXPECT_EQ(attained.interval.upper, share.interval.upper);
}

/// Integer values of 1 to 3 runs a unit.
RunsOfUnits random_runs(std::size_t units, Random& random) {
  RunsOfUnits runs(units);
  for (auto& unit : runs) {
    unit.resize(1 + random() % 3);
    for (History& history : unit) {
      double evaluations = 0;
      double value = 20 + std::floor(20 * uniform(random));
      while (value > 0 && evaluations < 60) {
        evaluations += 1 + std::floor(20 * uniform(random));
        history.push_back({evaluations, value});
        value -= 1 + std::floor(8 * uniform(random));
      }
    }
  }
  return runs;
}

TEST(AttainmentFunction, HasTheMeanAttainmentAsItsMeanOverAllIntegerLevels) {
  Random random(12);
  AttainmentGrid grid;
  for (double t = 1; t < 70; t += 3) grid.evaluations.push_back(t);
  for (double value = 5; value < 35; ++value) grid.values.push_back(value);
  for (int i = 0; i < 10; ++i) {
    const RunsOfUnits runs = random_runs(6, random);
    const auto attained = attainment_function(runs, grid);
    for (std::size_t t = 0; t < grid.evaluations.size(); ++t) {
      double over_levels = 0;
      for (const Attained& at : attained[t]) over_levels += at.share / 30;
      double mean = 0;
      for (const auto& unit : runs) {
        for (const History& history : unit) {
          mean += attainment(history, {5, 35}, grid.evaluations[t]) /
                  static_cast<double>(unit.size()) / 6;
        }
      }
      EXPECT_NEAR(over_levels, mean, 1e-12);
    }
  }
}

TEST(AttainmentFunction, DiffersByTheDifferenceOfBoth) {
  Random random(13);
  const AttainmentGrid grid = {{1, 10, 30}, {5, 15, 25}};
  const RunsOfUnits a = random_runs(12, random);
  const RunsOfUnits b = random_runs(12, random);
  const auto of_a = attainment_function(a, grid);
  const auto of_b = attainment_function(b, grid);
  const auto differences = attainment_difference(a, b, grid);
  const auto reversed = attainment_difference(b, a, grid);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Attained& difference = differences[i][k];
      EXPECT_NEAR(difference.share, of_a[i][k].share - of_b[i][k].share, 1e-12);
      EXPECT_NEAR(difference.interval.lower, -reversed[i][k].interval.upper, 1e-9);
      EXPECT_LT(difference.interval.lower, difference.share);
      EXPECT_GT(difference.interval.upper, difference.share);
    }
  }
  EXPECT_EQ(attainment_difference(a, a, grid)[1][1].share, 0);
}

TEST(AttainmentFunction, RefusesWhatDoesNotFit) {
  EXPECT_THROW(attainment_function({}, grid_by_hand), std::invalid_argument);
  EXPECT_THROW(attainment_function({{}}, grid_by_hand), std::invalid_argument);
  EXPECT_THROW(attainment_function({{{{0, 1}}}}, grid_by_hand), std::invalid_argument);
  EXPECT_THROW(attainment_difference(by_hand, {by_hand[0]}, grid_by_hand), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
