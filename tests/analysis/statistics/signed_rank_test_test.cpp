#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

/// Sum over the differences of sign times the number of smaller sizes, equal ones half: twice the
/// signed-rank sum but for a constant a difference, since a rank is that number plus 1/2.
double signed_rank_sum(const std::vector<double>& differences) {
  double sum = 0;
  for (const double x : differences) {
    double rank = 0.5;
    for (const double y : differences) {
      rank += std::abs(y) < std::abs(x) ? 1 : std::abs(y) == std::abs(x) ? 0.5 : 0;
    }
    sum += x > 0 ? rank : x < 0 ? -rank : 0;
  }
  return sum;
}

TEST(SignedRankTest, IsAsPublished) {
  // Hollander and Wolfe 1973, page 29: the depression scale at two visits; one-sided 0.01953 in R.
  const std::vector<double> first = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> second = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t k = 0; k < first.size(); ++k) differences.push_back(first[k] - second[k]);
  EXPECT_DOUBLE_EQ(signed_rank_test(differences), 20.0 / 512);
}

TEST(SignedRankTest, IsTheEnumerationOfAllSigns) {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> differences(1 + random() % 10);
    for (double& x : differences) x = std::floor(9 * uniform(random)) - 3;  // with ties and zeros
    std::replace(differences.begin(), differences.end(), 5.0, infinity);
    const double seen = std::abs(signed_rank_sum(differences));
    double as_far = 0;
    for (unsigned signs = 0; signs < 1U << differences.size(); ++signs) {
      std::vector<double> other = differences;
      for (std::size_t k = 0; k < other.size(); ++k) other[k] *= (signs >> k & 1U) != 0 ? -1 : 1;
      as_far += std::abs(signed_rank_sum(other)) >= seen ? 1 : 0;
    }
    EXPECT_NEAR(signed_rank_test(differences), as_far / std::exp2(differences.size()), 1e-12);
  }
}

TEST(SignedRankTest, IsNearTheShareOfRandomSignsWhereItIsNormal) {
  Random random(5);
  for (const double shift : {3.0, 3.2, 3.4}) {
    std::vector<double> differences;
    while (differences.size() < 300) {
      const double x = std::floor(7 * uniform(random) + shift) - 6;
      if (x != 0) differences.push_back(x);
    }
    const double seen = std::abs(signed_rank_sum(differences));
    std::vector<double> ranks;  // of each by itself: signed_rank_sum is linear in the signs
    for (std::size_t k = 0; k < differences.size(); ++k) {
      std::vector<double> other = differences;
      other[k] = -other[k];
      ranks.push_back((signed_rank_sum(differences) - signed_rank_sum(other)) / 2);
    }
    constexpr int draws = 4000;
    int as_far = 0;
    for (int i = 0; i < draws; ++i) {
      double sum = 0;
      for (const double rank : ranks) sum += (random() & 1U) != 0 ? rank : -rank;
      as_far += std::abs(sum) >= seen ? 1 : 0;
    }
    EXPECT_NEAR(signed_rank_test(differences), static_cast<double>(as_far) / draws, 0.03);
  }
}

TEST(SignedRankTest, SaysNothingWithoutDifferences) {
  EXPECT_EQ(signed_rank_test({}), 1);
  EXPECT_EQ(signed_rank_test({0, 0}), 1);
  EXPECT_THROW(signed_rank_test({1, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
