#include "solvers/plateau_search/descent.h"

#include <gtest/gtest.h>

#include "solvers/plateau_search/sight.h"
#include "tests/solvers/test_problems.h"

namespace ricochet::drifting {
namespace {

/// (x - c)' A (x - c) / 2 on [0, 1]^2, with a gradient.
Problem bowl(const Matrix& a, const Vector& c) {
  Problem problem = box_problem("bowl", 2, 0, 1, 0.5,
                                [a, c](const Vector& x) { return 0.5 * (x - c).dot(a * (x - c)); });
  differentiate_by(problem, [a, c](const Vector& x) -> Vector { return a * (x - c); });
  return problem;
}

const Matrix tilted{{2, 1}, {1, 3}};

TEST(ModelStep, IsNewtonsWithinTheBox) {
  const Vector u{{0.5, 0.5}};
  const Vector least{{0.25, 0.75}};
  EXPECT_TRUE((u + model_step(tilted, tilted * (u - least), u)).isApprox(least, 1e-12));
}

TEST(ModelStep, IsTheLeastOnTheBoundaryThatItMeets) {
  // The least without bounds is at (-1, 0.5); with x = 0 it is where 1 (0 + 1) + 3 (y - 0.5) = 0.
  const Vector u{{0.5, 0.5}};
  const Vector end = u + model_step(tilted, tilted * (u - Vector{{-1, 0.5}}), u);
  EXPECT_NEAR(end[0], 0, 1e-12);
  EXPECT_NEAR(end[1], 0.5 - 1.0 / 3, 1e-12);
}

TEST(Descent, EndsAtTheLeastOfAValley) {
  const Problem problem = bowl(Matrix{{100, 90}, {90, 100}}, Vector{{0.3, 0.6}});
  Evaluator evaluator(problem, {300});
  Sight sight(evaluator);
  Vector u{{0.9, 0.9}};
  const auto lowest = descend(sight, u, std::nullopt);
  ASSERT_TRUE(lowest);
  EXPECT_LT(*lowest, 1e-5);
  EXPECT_LT((u - Vector{{0.3, 0.6}}).norm(), 1e-2);
}

TEST(Descent, StepsAcrossACorner) {
  // |x - 0.3| + |y - 0.7|, from where the gradient leads to one corner after the other.
  Problem problem = box_problem("corners", 2, 0, 1, 0.9, [](const Vector& x) {
    return std::abs(x[0] - 0.3) + 5 * std::abs(x[1] - 0.7);
  });
  differentiate_by(problem, [](const Vector& x) -> Vector {
    return Vector{{x[0] > 0.3 ? 1.0 : -1.0, x[1] > 0.7 ? 5.0 : -5.0}};
  });
  Evaluator evaluator(problem, {500});
  Sight sight(evaluator);
  Vector u{{0.9, 0.9}};
  EXPECT_LT(descend(sight, u, std::nullopt).value(), 0.05);
}

TEST(Descent, LooksAtTheWidthThatItIsGiven) {
  Problem problem = bowl(tilted, Vector{{0.3, 0.6}});
  double shown = -1;
  problem.smoothed = [problem, &shown](double width) {
    shown = width;
    return problem;
  };
  Evaluator evaluator(problem, {20});
  Sight sight(evaluator);
  EXPECT_EQ(shown, 0);
  Vector u{{0.9, 0.9}};
  descend(sight, u, 0.25);
  EXPECT_EQ(shown, 0.25);
  sight.look(u);
  EXPECT_EQ(shown, 0);
}

TEST(Descent, IsOverWithTheRun) {
  const Problem problem = bowl(tilted, Vector{{0.3, 0.6}});
  Evaluator evaluator(problem, {4});
  Sight sight(evaluator);
  Vector u{{0.9, 0.9}};
  EXPECT_FALSE(descend(sight, u, std::nullopt));
}

}  // namespace
}  // namespace ricochet::drifting
