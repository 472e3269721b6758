#include "solvers/plateau_search/shape.h"

#include <gtest/gtest.h>

namespace ricochet::drifting {
namespace {

/// L L', from what L makes of the unit vectors.
Matrix covariance(const Shape& shape, Eigen::Index n) {
  Matrix factor(n, n);
  for (Eigen::Index k = 0; k < n; ++k) factor.col(k) = shape.shaped(Vector::Unit(n, k));
  return factor * factor.transpose();
}

TEST(Shape, StretchesAndShrinksByItsFormulas) {
  Shape shape(3);
  const Vector p{{1, 2, -1}};
  shape.stretch(p, 0.1);
  Matrix expected = 0.9 * Matrix::Identity(3, 3) + 0.1 * p * p.transpose();
  EXPECT_TRUE(covariance(shape, 3).isApprox(expected, 1e-12));
  const Vector z{{0.5, -1, 0.2}};
  const Vector step = shape.shaped(z);
  shape.shrink(z, 0.2);
  expected = 1.2 * expected - 0.2 * step * step.transpose();
  EXPECT_TRUE(covariance(shape, 3).isApprox(expected, 1e-12));
}

TEST(Shape, FlattensAlongADirectionAndNoOther) {
  Shape shape(2);
  shape.flatten(Vector{{3, 0}}, 0.5);
  EXPECT_TRUE(covariance(shape, 2).isApprox(Matrix{{0.25, 0}, {0, 1}}, 1e-12));
}

TEST(Shape, StaysACovarianceHoweverOftenItChanges) {
  Shape shape(4);
  for (int k = 0; k < 20000; ++k) {
    shape.stretch(Vector::Unit(4, k % 4) * 3, 0.3);
    shape.flatten(Vector::Ones(4), 0.4);
  }
  EXPECT_TRUE(covariance(shape, 4).allFinite());
  EXPECT_GT(covariance(shape, 4).trace(), 0);
}

TEST(Shape, BeginsAnewWhereNoCovarianceIsLeft) {
  Shape shape(2);
  shape.shrink(Vector{{5, 0}}, 0.5);  // takes away more than there is
  EXPECT_EQ(covariance(shape, 2), Matrix::Identity(2, 2));
}

}  // namespace
}  // namespace ricochet::drifting
