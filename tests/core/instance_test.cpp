#include "src/core/instance.h"

#include <gtest/gtest.h>

#include "tests/core/test_problems.h"

namespace ricochet {
namespace {

TEST(Instance, ZeroIsTheProblemAsStated) {
  const Problem problem = parabola(2);
  const Problem same = instance(problem, 0);
  EXPECT_EQ(same.lower, problem.lower);
  EXPECT_EQ(same.evaluate(problem.start).objective, problem.evaluate(problem.start).objective);
}

TEST(Instance, RefusesANegativeNumber) {
  EXPECT_THROW(instance(parabola(1), -1), std::invalid_argument);
}

TEST(Instance, MovesAndReflectsTheBoxButKeepsItsWidthAndItsOptimum) {
  bool reflected = false;
  bool kept = false;
  for (int number = 1; number <= 20; ++number) {
    const Problem moved = instance(parabola(1), number);
    EXPECT_NEAR(moved.upper[0] - moved.lower[0], 1.0, 1e-12);
    EXPECT_NE(moved.lower[0], 0.0);
    // The optimum lies a quarter of the width from one end of the box.
    const Vector from_lower = Vector::Constant(1, moved.lower[0] + 0.25);
    const Vector from_upper = Vector::Constant(1, moved.upper[0] - 0.25);
    const double low = moved.evaluate(from_lower).objective;
    const double high = moved.evaluate(from_upper).objective;
    EXPECT_NEAR(std::min(low, high), 0.0, 1e-12);
    (low < high ? kept : reflected) = true;
    EXPECT_GE(moved.start[0], moved.lower[0]);
    EXPECT_LE(moved.start[0], moved.upper[0]);
  }
  EXPECT_TRUE(reflected && kept);
}

TEST(Instance, KeepsTheDerivativesConsistent) {
  for (int number = 1; number <= 10; ++number) {
    const Problem moved = instance(parabola(3), number);
    const Vector x = moved.start;
    const Derivatives d = moved.differentiate(x);
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector up = x;
      Vector down = x;
      up[i] += 1e-6;
      down[i] -= 1e-6;
      const double slope =
          (moved.evaluate(up).objective - moved.evaluate(down).objective) / (up[i] - down[i]);
      EXPECT_NEAR(d.gradient[i], slope, 1e-8);
    }
  }
}

TEST(Instance, KeepsTheResidualsConsistent) {
  for (int number = 1; number <= 10; ++number) {
    const Problem moved = instance(parabola(3), number);
    const Residuals r = moved.residuals(moved.start);
    const Derivatives d = moved.differentiate(moved.start);
    EXPECT_NEAR(r.values.squaredNorm() / 2, d.values.objective, 1e-12);
    EXPECT_LT((r.jacobian.transpose() * r.values - d.gradient).norm(), 1e-12);
  }
}

TEST(Instance, DependsOnNameAndNumberOnly) {
  EXPECT_EQ(instance(parabola(2), 3).lower, instance(parabola(2), 3).lower);
  EXPECT_NE(instance(parabola(2), 3).lower, instance(parabola(2), 4).lower);
  Problem other = parabola(2);
  other.name = "other";
  EXPECT_NE(instance(parabola(2), 3).lower, instance(other, 3).lower);
}

}  // namespace
}  // namespace ricochet
