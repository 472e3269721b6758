#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/running_time.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

TEST(ExpectedRunningTime, ChargesAFailedRunItsOwnLength) {
  // 20 + 100 + 60 evaluations for two successes.
  EXPECT_EQ(expected_running_time({{20, true}, {100, false}, {60, true}}), 90.0);
}

TEST(ExpectedRunningTime, IsNothingWithoutASuccess) {
  EXPECT_FALSE(expected_running_time({{20, false}}));
  EXPECT_FALSE(expected_running_time({}));
}

std::vector<Effort> runs_of(int failures, int successes, double spent) {
  std::vector<Effort> runs(static_cast<std::size_t>(failures), {spent, false});
  runs.insert(runs.end(), static_cast<std::size_t>(successes), {spent, true});
  return runs;
}

TEST(ExpectedRunningTime, HasTheIntervalOfTheShareWhereAllRunsAreOfOneLength) {
  const Interval interval = expected_running_time_interval(runs_of(12, 3, 50));
  EXPECT_DOUBLE_EQ(interval.lower, 50 / wilson_interval(3, 15).upper);
  EXPECT_DOUBLE_EQ(interval.upper, 50 / wilson_interval(3, 15).lower);
}

TEST(ExpectedRunningTime, HasAnIntervalOfLengthAndShareWhereTheyAreUnrelated) {
  // Failures and successes of the lengths 40 and 60: their correlation is 0. Log-mean: 50, standard
  // error 10 sqrt(1 / 7), Student's t of 7 degrees of freedom 2.364624.
  const std::vector<Effort> runs = {{40, true}, {60, true}, {40, false}, {60, false},
                                    {40, true}, {60, true}, {40, false}, {60, false}};
  const double of_mean = 2.364624 * 10 / std::sqrt(7.0) / 50;
  const double of_share = std::log(wilson_interval(4, 8).upper / 0.5);
  const Interval interval = expected_running_time_interval(runs);
  EXPECT_NEAR(interval.lower, 100 * std::exp(-std::hypot(of_mean, of_share)), 1e-4);
}

TEST(ExpectedRunningTime, IsMoreCertainWhereSuccessesAreTheShorterTheMoreThereAre) {
  // Lengths and failures that go together vary the estimate more than those that are opposed.
  const Interval together = expected_running_time_interval(
      {{10, true}, {90, false}, {10, true}, {90, false}, {10, true}, {90, false}});
  const Interval opposed = expected_running_time_interval(
      {{90, true}, {10, false}, {90, true}, {10, false}, {90, true}, {10, false}});
  EXPECT_LT(together.lower, opposed.lower);
  EXPECT_GT(together.upper, opposed.upper);
}

TEST(ExpectedRunningTime, IsAtLeastSoMuchWhereNoRunSucceeded) {
  const Interval interval = expected_running_time_interval(runs_of(15, 0, 50));
  // The largest share at which 15 failures still have the chance 2.5 %.
  EXPECT_NEAR(std::pow(1 - 50 / interval.lower, 15), 0.025, 1e-12);
  EXPECT_EQ(interval.upper, infinity);
}

TEST(ExpectedRunningTime, IsUnknownAfterOneSuccess) {
  EXPECT_EQ(expected_running_time_interval({{50, true}}).lower, 0);
  EXPECT_EQ(expected_running_time_interval({{50, true}}).upper, infinity);
}

TEST(ExpectedRunningTime, ScalesWithItsUnit) {
  const std::vector<Effort> seconds = {{20, true}, {100, false}, {60, true}, {1, true}};
  std::vector<Effort> milliseconds = seconds;
  for (Effort& run : milliseconds) run.spent *= 1000;
  const Interval small = expected_running_time_interval(seconds);
  const Interval large = expected_running_time_interval(milliseconds);
  EXPECT_NEAR(large.lower, 1000 * small.lower, 1e-9 * large.lower);
  EXPECT_NEAR(large.upper, 1000 * small.upper, 1e-9 * large.upper);
  EXPECT_EQ(expected_running_time_interval(runs_of(1, 1, 0)).upper, 0);
}

TEST(ExpectedRunningTime, RefusesWhatDoesNotFit) {
  EXPECT_THROW(expected_running_time_interval({}), std::invalid_argument);
  EXPECT_THROW(expected_running_time_interval({{-1, true}}), std::invalid_argument);
  EXPECT_THROW(expected_running_time_interval({{infinity, false}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
