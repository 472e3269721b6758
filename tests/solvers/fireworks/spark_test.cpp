#include <gtest/gtest.h>

#include <vector>

#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {
namespace {

constexpr int draws = 40000;

/// Mean and variance of what is drawn.
struct Moments {
  double mean = 0, variance = 0;
};

template <class Draw>
Moments moments(Draw draw) {
  double sum = 0, squares = 0;
  for (int k = 0; k < draws; ++k) {
    const double x = draw();
    sum += x;
    squares += x * x;
  }
  const double mean = sum / draws;
  return {mean, squares / draws - mean * mean};
}

class Spark : public testing::Test {
 protected:
  Random random_{1};
  const std::vector<Eigen::Index> moved_ = {0, 2};
  const Vector x_{{1, 2, 3}};
};

TEST_F(Spark, IsMovedByOneDrawInTheUnitOfEachCoordinate) {
  for (int k = 0; k < 100; ++k) {
    Vector x = x_;
    displace(x, moved_, 0.5, Vector{{1, 1, 4}}, Offsets::one, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_LE(std::abs(x[0] - 1), 0.5);
    EXPECT_NEAR(x[2] - 3, 4 * (x[0] - 1), 1e-14);
  }
}

TEST_F(Spark, IsMovedByDrawsOfTheirOwn) {
  double product = 0;
  const Moments of_last = moments([&] {
    Vector x = x_;
    displace(x, moved_, 0.5, Vector{{1, 1, 4}}, Offsets::each, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_LE(std::abs(x[2] - 3), 2);
    product += (x[0] - 1) * (x[2] - 3) / draws;
    return x[2] - 3;
  });
  EXPECT_NEAR(of_last.mean, 0, 0.03);
  EXPECT_NEAR(of_last.variance, 4.0 / 3, 0.03);  // of U(-2, 2)
  EXPECT_NEAR(product, 0, 0.01);
}

TEST_F(Spark, IsMultipliedByOneNormalNumberOfMeanAndVarianceOne) {
  const Moments of_factor = moments([&] {
    Vector x = x_;
    multiply(x, moved_, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_NEAR(x[2], 3 * x[0], 1e-12);
    return x[0];
  });
  EXPECT_NEAR(of_factor.mean, 1, 0.03);
  EXPECT_NEAR(of_factor.variance, 1, 0.05);
}

TEST_F(Spark, ApproachesTheBestByOneNormalNumber) {
  const Moments of_factor = moments([&] {
    Vector x = x_;
    approach(x, moved_, Vector{{2, 7, 1}}, random_);
    EXPECT_EQ(x[1], 2);
    EXPECT_NEAR(x[2] - 3, -2 * (x[0] - 1), 1e-12);
    return x[0] - 1;
  });
  EXPECT_NEAR(of_factor.mean, 0, 0.03);
  EXPECT_NEAR(of_factor.variance, 1, 0.05);
}

TEST_F(Spark, OfTheBestThatApproachesItselfStays) {
  Vector x = x_;
  approach(x, moved_, x_, random_);
  EXPECT_EQ(x, x_);
}

TEST_F(Spark, IsGuidedFromTheWorstToTheBest) {
  const Matrix sparks{{0, 0}, {1, 0}, {2, 5}, {3, 1}, {4, 7}};
  const std::vector<Eigen::Index> order = {4, 2, 0, 1, 3};
  Vector x{{10, 20}};
  guide(x, sparks, order, 0.4);  // (4, 7), (2, 5) against (1, 0), (3, 1)
  EXPECT_LT((x - Vector{{11, 25.5}}).norm(), 1e-12);
  x = Vector{{10, 20}};
  guide(x, sparks, order, 0.01);  // at least one
  EXPECT_LT((x - Vector{{11, 26}}).norm(), 1e-12);
  x = Vector{{10, 20}};
  guide(x, sparks, order, 1);  // the same on both sides
  EXPECT_LT((x - Vector{{10, 20}}).norm(), 1e-12);
  guide(x, sparks, order, 0.4, 2);
  EXPECT_LT((x - Vector{{12, 31}}).norm(), 1e-12);
  EXPECT_LT((mean_of_best(sparks, order, 0.4) - Vector{{3, 6}}).norm(), 1e-12);
}

}  // namespace
}  // namespace ricochet::fireworks
