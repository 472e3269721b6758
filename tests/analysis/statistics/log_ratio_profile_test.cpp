#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "src/analysis/statistics/attainment.h"
#include "tests/core/infinity.h"

namespace ricochet {
namespace {

void expect_bar(const LogRatio& bar, std::size_t problem, double log2_ratio, SolvedBy solved_by) {
  EXPECT_EQ(bar.problem, problem);
  EXPECT_DOUBLE_EQ(bar.log2_ratio, log2_ratio);
  EXPECT_EQ(bar.solved_by, solved_by);
}

TEST(LogRatioProfile, HasTheBarsComputedByHand) {
  const auto bars =
      log_ratio_profile({infinity, 8, 4, infinity, 3, 1}, {infinity, 2, 4, 3, infinity, 2});
  ASSERT_EQ(bars.size(), 7U);
  expect_bar(bars[0], 0, -2.2, SolvedBy::neither);
  expect_bar(bars[1], 4, -2.2, SolvedBy::only_a);
  expect_bar(bars[2], 5, -1, SolvedBy::both);
  expect_bar(bars[3], 2, 0, SolvedBy::both);
  expect_bar(bars[4], 1, 2, SolvedBy::both);
  expect_bar(bars[5], 3, 2.2, SolvedBy::only_b);
  expect_bar(bars[6], 0, 2.2, SolvedBy::neither);
}

TEST(LogRatioProfile, OfTheOtherIsItsMirror) {
  const std::vector<double> a = {5, 7, infinity, 1, infinity, 2};
  const std::vector<double> b = {6, 3, 4, infinity, infinity, 9};
  const auto one = log_ratio_profile(a, b);
  const auto other = log_ratio_profile(b, a);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_DOUBLE_EQ(one[k].log2_ratio, -other[other.size() - 1 - k].log2_ratio);
    EXPECT_EQ(one[k].problem, other[other.size() - 1 - k].problem);
  }
}

TEST(LogRatioProfile, HasAFailureOfALengthWithoutAnyRatio) {
  const auto bars = log_ratio_profile({1, infinity}, {infinity, infinity});
  ASSERT_EQ(bars.size(), 3U);
  expect_bar(bars[0], 1, -1.1, SolvedBy::neither);
  expect_bar(bars[1], 0, -1.1, SolvedBy::only_a);
  expect_bar(bars[2], 1, 1.1, SolvedBy::neither);
}

TEST(LogRatioProfile, RefusesWhatDoesNotFit) {
  EXPECT_THROW(log_ratio_profile({}, {}), std::invalid_argument);
  EXPECT_THROW(log_ratio_profile({1, 2}, {1}), std::invalid_argument);
  EXPECT_THROW(log_ratio_profile({0}, {1}), std::invalid_argument);
  EXPECT_THROW(log_ratio_profile({1}, {std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
