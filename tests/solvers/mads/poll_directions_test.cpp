#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/random.h"
#include "solvers/mads.h"

namespace ricochet {
namespace {

TEST(PollBasis, IsOrthogonalAndOfIntegersNoLongerThanThePoll) {
  Random random(1);
  for (const Eigen::Index n : {1, 2, 3, 5, 16}) {
    for (int index = 0; index <= 26; ++index) {
      const Matrix basis = poll_basis(normal(n, random), index);
      EXPECT_EQ(basis, basis.unaryExpr([](double entry) { return std::round(entry); }));
      const double length = basis.col(0).norm();
      EXPECT_GE(length, 1.0);
      EXPECT_LE(length, std::ldexp(1.0, index));
      // Integers: what is orthogonal is so to the last digit, but for products beyond 2^53.
      const Matrix off = basis.transpose() * basis - length * length * Matrix::Identity(n, n);
      EXPECT_LE(off.cwiseAbs().maxCoeff(), 1e-14 * length * length) << n << " " << index;
    }
  }
}

TEST(PollBasis, IsNearlyAsLongAsThePollOnceTheMeshIsFine) {
  Random random(2);
  for (const Eigen::Index n : {1, 2, 5, 16}) {
    for (int index = 12; index <= 26; ++index) {
      const double length = poll_basis(normal(n, random), index).col(0).norm();
      EXPECT_GT(length, 0.8 * std::ldexp(1.0, index)) << n << " " << index;
    }
  }
}

TEST(PollBasis, ReflectsTheDirectionItIsGiven) {
  const Vector direction{{0.3, -0.5, 0.8}};
  const Vector reflected = poll_basis(direction, 24) * direction;
  EXPECT_LT((reflected.normalized() + direction.normalized()).norm(), 1e-3);
}

TEST(PollBasis, LeadsIntoTheAxesOnTheCoarsestMesh) {
  const Matrix basis = poll_basis(Vector{{0.6, -0.7}}, 0);
  EXPECT_EQ(basis, (Matrix{{1, 0}, {0, -1}}));
}

/// Vectors that span the space positively: every other one makes an acute angle with one of them.
TEST(PollDirections, LeadEverywhere) {
  Random random(3);
  for (const Eigen::Index n : {1, 2, 4, 9}) {
    for (int draw = 0; draw < 200; ++draw) {
      const Matrix basis = poll_basis(normal(n, random), draw % 20);
      const auto directions = poll_directions(basis, normal(n, random));
      EXPECT_EQ(directions.size(), static_cast<std::size_t>(n + 1));
      const Vector any = normal(n, random).normalized();
      double nearest = -1;
      for (const Vector& d : directions) nearest = std::max(nearest, any.dot(d.normalized()));
      // The cosine measure of n orthogonal unit vectors and the opposite of their sum.
      const auto size = static_cast<double>(n);
      const double cosine = 1 / std::sqrt(size * size + 2 * (size - 1) * std::sqrt(size));
      EXPECT_GE(nearest, cosine - 1e-12);
    }
  }
}

TEST(PollDirections, BeginWithThoseAlongTheLeadingOneAndEndWithTheOppositeOfTheirSum) {
  Random random(4);
  const Vector leading{{1, 2, -3}};
  const auto directions = poll_directions(poll_basis(normal(3, random), 6), leading);
  ASSERT_EQ(directions.size(), 4U);
  EXPECT_GE(directions[0].dot(leading), directions[1].dot(leading));
  EXPECT_GE(directions[1].dot(leading), directions[2].dot(leading));
  EXPECT_GE(directions[2].dot(leading), 0);
  EXPECT_EQ(directions[3], -(directions[0] + directions[1] + directions[2]));
}

}  // namespace
}  // namespace ricochet
