#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "solvers/fireworks/population.h"

namespace ricochet::fireworks {
namespace {

using testing::ElementsAre;

constexpr int draws = 40000;

std::vector<double> list_of(const Vector& vector) {
  return {vector.begin(), vector.end()};
}

TEST(Selection, TakesTheFirstOfTheBest) {
  Random random;
  const std::vector<TrueValues> worths = {{5, 0}, {-9, 1}, {2, 0}, {2, 0}};
  EXPECT_EQ(best_of(worths, Ties::first, random), 2);
}

TEST(Selection, TakesTheLeastViolatedWhereNothingIsFeasible) {
  Random random;
  const std::vector<TrueValues> worths = {{5, 2}, {-9, 3}, {7, 2}};
  EXPECT_EQ(best_of(worths, Ties::first, random), 0);
}

TEST(Selection, TakesAnyOfTheBestAlike) {
  Random random(1);
  const std::vector<TrueValues> worths = {{2, 0}, {5, 0}, {2, 0}, {2, 1}, {2, 0}};
  std::map<Eigen::Index, double> shares;
  for (int k = 0; k < draws; ++k) shares[best_of(worths, Ties::any, random)] += 1.0 / draws;
  ASSERT_EQ(shares.size(), 3U);
  for (const Eigen::Index i : {0, 2, 4}) EXPECT_NEAR(shares[i], 1.0 / 3, 0.01);
}

TEST(DistanceSums, AddUpTheDistancesToAll) {
  EXPECT_THAT(list_of(distance_sums(Matrix{{0}, {1}, {3}})), ElementsAre(4, 3, 5));
  EXPECT_THAT(list_of(distance_sums(Matrix{{0, 0}, {3, 4}})), ElementsAre(5, 5));
}

TEST(DistanceSums, AreAllOneWhereAllPointsCoincideOrOneIsNoNumber) {
  EXPECT_THAT(list_of(distance_sums(Matrix::Constant(3, 1, 0.1))), ElementsAre(1, 1, 1));
  EXPECT_THAT(list_of(distance_sums(Matrix::Constant(3, 2, 7))), ElementsAre(1, 1, 1));
  EXPECT_THAT(list_of(distance_sums(Matrix{{-1e200, 0}, {1e200, 0}})), ElementsAre(1, 1));
}

TEST(DistanceSums, AgreeWithTheirDefinition) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Index n = 1 + trial % 5;
    const auto count = static_cast<Eigen::Index>(2 + 40 * uniform(random));
    const Matrix points = normal(n * count, random).reshaped(count, n);
    const Vector sums = distance_sums(points);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double sum = (points.rowwise() - points.row(i)).rowwise().norm().sum();
      ASSERT_NEAR(sums[i], sum, 1e-12 * sum);
    }
  }
}

class Selected : public testing::Test {
 protected:
  const Matrix points_{{0}, {1}, {3}, {10}};
  const std::vector<TrueValues> worths_ = {{5, 0}, {4, 0}, {3, 0}, {4, 0}};
  Random random_{1};

  /// How often each is the one drawn beside the best.
  std::map<Eigen::Index, double> shares(const SelectionOptions& options) {
    std::map<Eigen::Index, double> shares;
    for (int k = 0; k < draws; ++k) {
      const auto chosen = selected(points_, worths_, 2, options, random_);
      EXPECT_EQ(chosen.at(0), 2);
      shares[chosen.at(1)] += 1.0 / draws;
    }
    return shares;
  }
};

TEST_F(Selected, AreTheBestAndOthersByTheirDistances) {
  const Vector sums{{14, 12, 12, 26}};
  const auto drawn = shares({});
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(drawn.at(i), sums[i] / 64, 0.01);
}

TEST_F(Selected, WithoutReplacementHaveTheBestOnlyOnce) {
  const Vector sums{{14, 12, 0, 26}};
  const auto drawn = shares({.replacement = false});
  EXPECT_FALSE(drawn.contains(2));
  for (const Eigen::Index i : {0, 1, 3}) EXPECT_NEAR(drawn.at(i), sums[i] / 52, 0.01);
  for (int k = 0; k < 100; ++k) {
    const auto all = selected(points_, worths_, 4, {.replacement = false}, random_);
    EXPECT_EQ(std::set<Eigen::Index>(all.begin(), all.end()).size(), 4U);
  }
}

TEST_F(Selected, MayBeUniform) {
  const auto drawn = shares({.others = Others::uniform});
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(drawn.at(i), 0.25, 0.01);
}

TEST_F(Selected, NeverLoseTheBest) {
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<TrueValues> worths(12);
    for (TrueValues& worth : worths) {
      worth = {std::floor(5 * uniform(random_)), std::floor(2 * uniform(random_))};
    }
    const Matrix points = normal(24, random_).reshaped(12, 2);
    for (const Ties ties : {Ties::first, Ties::any}) {
      const auto chosen = selected(points, worths, 5, {.ties = ties}, random_);
      ASSERT_EQ(chosen.size(), 5U);
      const TrueValues& kept = worths[static_cast<std::size_t>(chosen.front())];
      for (const TrueValues& worth : worths) ASSERT_FALSE(better(worth, kept));
    }
  }
}

}  // namespace
}  // namespace ricochet::fireworks
