#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ricochet/random.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "tests/core/infinity.h"

namespace ricochet {
namespace {

/// How often a value of a is above one of b, ties half, less how often it would be by chance.
double excess(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (const double x : a) {
    for (const double y : b) sum += x > y ? 0.5 : x < y ? -0.5 : 0;
  }
  return sum;
}

TEST(RankSumTest, IsAsPublished) {
  // Hollander and Wolfe 1973, page 69: permeability of the membrane at term and before; one-sided
  // 0.1272 in R.
  const RankSumTest test = rank_sum_test(
      {0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, {1.15, 0.88, 0.90, 0.74, 1.21});
  EXPECT_NEAR(test.p_value, 2 * 0.1272, 1e-4);
  EXPECT_DOUBLE_EQ(test.smaller, 15.0 / 50);
}

TEST(RankSumTest, IsTheEnumerationOfAllDivisions) {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> pooled(2 + random() % 9);
    for (double& x : pooled) x = std::floor(6 * uniform(random));  // with ties
    std::replace(pooled.begin(), pooled.end(), 5.0, infinity);
    const std::size_t size = 1 + random() % (pooled.size() - 1);
    const auto divided = [&](unsigned choice) {
      std::vector<double> a;
      std::vector<double> b;
      for (std::size_t k = 0; k < pooled.size(); ++k) {
        ((choice >> k & 1U) != 0 ? a : b).push_back(pooled[k]);
      }
      return std::pair(a, b);
    };
    const auto [a, b] = divided((1U << size) - 1);
    double as_far = 0;
    double all = 0;
    for (unsigned choice = 0; choice < 1U << pooled.size(); ++choice) {
      if (static_cast<std::size_t>(std::popcount(choice)) != size) continue;
      const auto [other_a, other_b] = divided(choice);
      ++all;
      as_far += std::abs(excess(other_a, other_b)) >= std::abs(excess(a, b)) ? 1 : 0;
    }
    const RankSumTest test = rank_sum_test(a, b);
    EXPECT_NEAR(test.p_value, as_far / all, 1e-12);
    const auto pairs = static_cast<double>(a.size() * b.size());
    EXPECT_NEAR(test.smaller, 0.5 - excess(a, b) / pairs, 1e-12);
  }
}

TEST(RankSumTest, IsNearTheShareOfRandomDivisionsWhereItIsNormal) {
  Random random(3);
  for (const double shift : {0.0, 1.0, 2.0}) {
    std::vector<double> pooled(70);
    for (std::size_t k = 0; k < pooled.size(); ++k) {
      pooled[k] = std::floor(6 * uniform(random) + (k < 40 ? shift : 0));
    }
    const auto test_of = [&](const std::vector<double>& values) {
      return std::pair(std::vector<double>(values.begin(), values.begin() + 40),
                       std::vector<double>(values.begin() + 40, values.end()));
    };
    const auto [a, b] = test_of(pooled);
    const double seen = std::abs(excess(a, b));
    constexpr int divisions = 4000;
    int as_far = 0;
    for (int i = 0; i < divisions; ++i) {
      std::shuffle(pooled.begin(), pooled.end(), random);
      const auto [other_a, other_b] = test_of(pooled);
      as_far += std::abs(excess(other_a, other_b)) >= seen ? 1 : 0;
    }
    EXPECT_NEAR(rank_sum_test(a, b).p_value, static_cast<double>(as_far) / divisions, 0.03);
  }
}

TEST(RankSumTest, SaysNothingOfEqualValues) {
  EXPECT_DOUBLE_EQ(rank_sum_test({1, 1, 1}, {1, 1}).p_value, 1);
  const std::vector<double> never(50, infinity);
  EXPECT_EQ(rank_sum_test(never, never).p_value, 1);
  EXPECT_EQ(rank_sum_test(never, never).smaller, 0.5);
}

TEST(RankSumTest, RefusesWhatDoesNotFit) {
  EXPECT_THROW(rank_sum_test({}, {1}), std::invalid_argument);
  EXPECT_THROW(rank_sum_test({std::nan("")}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
