#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "solvers/fireworks/population.h"

namespace ricochet::fireworks {
namespace {

Matrix drawn_from(const SearchDistribution& distribution, Eigen::Index count, Random& random) {
  Matrix points(count, distribution.mean().size());
  for (Eigen::Index i = 0; i < count; ++i) points.row(i) = distribution.draw(random).transpose();
  return points;
}

TEST(SearchDistribution, DrawsWithItsMeanAndScale) {
  Random random(1);
  const SearchDistribution distribution(Vector{{3, -1}}, 0.5);
  const Matrix points = drawn_from(distribution, 20000, random);
  EXPECT_LT((points.colwise().mean().transpose() - distribution.mean()).norm(), 0.02);
  const Matrix apart = points.rowwise() - points.colwise().mean();
  EXPECT_LT((apart.transpose() * apart / 20000 - 0.25 * Matrix::Identity(2, 2)).norm(), 0.01);
  EXPECT_EQ(distribution.width(), 0.5);
}

TEST(SearchDistribution, HasItsSurfaceWhereATypicalPointLies) {
  const SearchDistribution distribution(Vector::Zero(2), 0.5);
  EXPECT_NEAR(distribution.distance(Vector{{0.5, 1}}), 1 + 4, 1e-12);
  // A standard normal vector of two coordinates is sqrt(pi / 2) long on average.
  EXPECT_NEAR(std::sqrt(distribution.expected()), std::sqrt(std::acos(-1) / 2), 2e-3);
  EXPECT_NEAR(distribution.radius_towards(Vector{{3, 4}}), 0.5 * std::sqrt(distribution.expected()),
              1e-12);
}

TEST(SearchDistribution, IsFittedToAPoint) {
  SearchDistribution distribution(Vector{{1, 2, 3}}, 0.5);
  const Matrix point{{1.2, 2, 6}};
  distribution.fit(point, 1);
  const Vector there = point.row(0).transpose();
  EXPECT_NEAR(distribution.distance(there), distribution.expected(), 1e-4);
  EXPECT_NEAR(distribution.radius_towards(there), (there - distribution.mean()).norm(), 1e-4);
  // Across, it stays as it was.
  EXPECT_NEAR(distribution.radius_towards(Vector{{1, 5, 3}}),
              0.5 * std::sqrt(distribution.expected()), 1e-6);

  SearchDistribution nearer(Vector{{0}}, 1);
  const double before = std::sqrt(nearer.expected());
  nearer.fit(Matrix::Constant(1, 1, 3 * before), 0.5);
  EXPECT_GT(nearer.radius_towards(Vector{{1}}), 1.5 * before);
  EXPECT_LT(nearer.radius_towards(Vector{{1}}), 3 * before);
  nearer.fit(Matrix::Zero(1, 1), 1);  // the mean itself has no direction
  EXPECT_GT(nearer.radius_towards(Vector{{1}}), 1.5 * before);
}

TEST(SearchDistribution, MovesToTheBetterHalfAndTurnsAlongIt) {
  Random random(1);
  SearchDistribution distribution(Vector::Zero(2), 1);
  for (int generation = 0; generation < 60; ++generation) {
    const Matrix sparks = drawn_from(distribution, 40, random);
    std::vector<Eigen::Index> order(40);
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto value = [&](Eigen::Index i) {
      const double along = sparks(i, 0) + sparks(i, 1) - 4, across = sparks(i, 0) - sparks(i, 1);
      return along * along + 1e4 * across * across;
    };
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index a, Eigen::Index b) { return value(a) < value(b); });
    distribution.adapt(sparks, order);
    if (generation == 15) {
      EXPECT_GT(distribution.distance(distribution.mean() + Vector{{1, -1}}),
                20 * distribution.distance(distribution.mean() + Vector{{1, 1}}));
    }
  }
  EXPECT_LT((distribution.mean() - Vector{{2, 2}}).norm(), 1e-2);
  EXPECT_LT(distribution.width(), 0.1);
}

TEST(SearchDistribution, StaysUsableWhereAllSparksAreOne) {
  SearchDistribution distribution(Vector::Zero(2), 1);
  const std::vector<Eigen::Index> order = {0, 1, 2, 3};
  for (int k = 0; k < 100; ++k) distribution.adapt(Matrix::Constant(4, 2, 0.5), order);
  EXPECT_GT(distribution.width(), 0);
  EXPECT_LT(distribution.width(), 1e3);
  EXPECT_TRUE(distribution.mean().allFinite());
}

}  // namespace
}  // namespace ricochet::fireworks
