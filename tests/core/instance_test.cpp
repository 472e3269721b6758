#include "src/core/instance.h"

#include "tests/core/hessian_check.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

bool is_inside(const Problem& problem, const Vector& x) {
  return (x.array() >= problem.lower.array()).all() && (x.array() <= problem.upper.array()).all();
}

/// Of instances 1 to 40: where in its box, from 0 to 1, the best point's first coordinate is (from
/// `least` to `most`, and not always above `below` or below `above`), and which share of the stated
/// box's width it has.
void expect_spread(const Problem& problem, double least, double most, double below, double above,
                   double narrowest) {
  double lowest = 1, highest = 0;
  for (int number = 1; number <= 40; ++number) {
    const Problem moved = instance(problem, number);
    EXPECT_TRUE(is_inside(moved, moved.start) && is_inside(moved, *moved.best_point));
    EXPECT_NEAR(moved.evaluate(*moved.best_point).objective, 0, 1e-12);
    const Vector width = moved.upper - moved.lower;
    EXPECT_GE(width.minCoeff(), narrowest - 1e-12);
    EXPECT_LE(width.maxCoeff(), 1 + 1e-12);
    const double place = ((*moved.best_point)[0] - moved.lower[0]) / width[0];
    lowest = std::min(lowest, place);
    highest = std::max(highest, place);
  }
  EXPECT_GE(lowest, least - 1e-12);
  EXPECT_LT(lowest, below);
  EXPECT_LE(highest, most + 1e-12);
  EXPECT_GT(highest, above);
}

/// The functions are not defined outside the box.
Problem defined_inside(const Problem& problem) {
  Problem result = problem;
  result.evaluate = [problem](const Vector& x) {
    EXPECT_TRUE(is_inside(problem, x));
    return problem.evaluate(x);
  };
  return result;
}

/// A problem with its best point at an end of its box, beyond which it is its mirror image.
Problem mirrored() {
  Problem problem = parabola(2);
  problem.name = "mirrored";
  problem.mirrors = true;
  problem.best_point = Vector::Zero(2);
  problem.evaluate = [](const Vector& x) { return Values{x.squaredNorm(), {}}; };
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * x; });
  problem.residuals = [](const Vector& x) { return distances(x, 0); };
  return problem;
}

/// A valley that no axis follows.
Problem valley() {
  Problem problem = parabola(3);
  problem.name = "valley";
  problem.rotates = true;
  problem.residuals = [](const Vector& x) {
    const Vector root = Vector{{2, 20, 200}}.cwiseSqrt();
    return Residuals{root.array() * (x.array() - 0.25), root.asDiagonal()};
  };
  const Vector steepness{{1, 10, 100}};
  problem.evaluate = [steepness](const Vector& x) {
    return Values{steepness.dot((x.array() - 0.25).square().matrix()), {}};
  };
  differentiate_by(problem, [steepness](const Vector& x) -> Vector {
    return 2 * steepness.array() * (x.array() - 0.25);
  });
  return problem;
}

TEST(Instance, ZeroIsTheProblemAsStatedAndNegativeOnesAreNone) {
  EXPECT_EQ(instance(parabola(2), 0).lower, parabola(2).lower);
  EXPECT_THROW(instance(parabola(1), -1), std::invalid_argument);
}

TEST(Instance, MovesAndReflectsTheBoxAboutTheBestPoint) {
  expect_spread(defined_inside(parabola(2)), 0, 1, 0.15, 0.85, 0.5);
  // Off the end beyond which it is mirrored, and at will where it is defined outside.
  expect_spread(defined_inside(mirrored()), 0.1, 0.9, 0.25, 0.75, 0.5);
  expect_spread(valley(), 0.1, 0.9, 0.2, 0.8, 1);
  Problem open = parabola(1);
  open.best_point.reset();
  const Problem moved = instance(open, 1);
  EXPECT_NEAR(moved.upper[0] - moved.lower[0], 1, 1e-12) << "where no best point is known";
}

TEST(Instance, ShowsTheProblemAsStatedWithDerivativesAndResidualsThatFit) {
  for (const Problem& problem :
       {defined_inside(parabola(3)), defined_inside(mirrored()), valley()}) {
    SCOPED_TRACE(problem.name);
    for (int number = 0; number <= 40; ++number) {
      const Problem moved = instance(problem, number);
      for (const Vector& x : {moved.lower, moved.upper, moved.start, *moved.best_point}) {
        const double objective = moved.evaluate(x).objective;
        EXPECT_EQ(objective, problem.evaluate(stated_point(problem, number, x)).objective);
        const Derivatives d = moved.differentiate(x);
        const Residuals r = moved.residuals(x);
        EXPECT_NEAR(r.values.squaredNorm() / 2, objective, 1e-11);
        EXPECT_LT((r.jacobian.transpose() * r.values - d.gradient).norm(), 1e-11);
        if (problem.rotates) continue;  // else both are the square of the distance
        const Vector way = x - *moved.best_point;
        EXPECT_NEAR(objective, way.squaredNorm(), 1e-12);
        EXPECT_LT((d.gradient - 2 * way).norm(), 1e-12);
      }
      const Vector best = stated_point(problem, number, *moved.best_point);
      EXPECT_LT((best - *problem.best_point).norm(), 1e-12);
    }
  }
}

TEST(Instance, TurnsAProblemAboutItsBestPoint) {
  for (int number = 1; number <= 10; ++number) {
    const Problem moved = instance(valley(), number);
    // The second derivatives: their trace stays, but no axis has one of its own.
    const double h = 1e-3;
    double trace = 0;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector up = *moved.best_point + h * Vector::Unit(3, i);
      const double curvature = 2 * moved.evaluate(up).objective / (h * h);
      for (const double own : {2.0, 20.0, 200.0}) EXPECT_GT(std::abs(curvature - own), 1e-3 * own);
      trace += curvature;
    }
    EXPECT_NEAR(trace, 222, 1e-6);
  }
}

TEST(Instance, KeepsTheSecondDerivativesConsistentHoweverItIsMovedReflectedAndTurned) {
  Random random(1);
  for (const bool rotates : {false, true}) {
    Problem problem = constrained();
    problem.equalities = 1;
    problem.best_point = Vector{{1, -1}};
    problem.rotates = rotates;
    int compared = 0;
    for (int number = 0; number <= 10; ++number) {
      const Problem moved = instance(problem, number);
      const Vector x = moved.lower + 0.5 * (moved.upper - moved.lower);
      compared += expect_hessian_of_gradients(moved, x, uniform(random), normal(2, random));
    }
    EXPECT_GT(compared, 40);
  }
  EXPECT_FALSE(instance(parabola(2), 1).lagrangian_hessian) << "which has none";
}

TEST(Instance, KeepsAPublishedStartAndItsMultiples) {
  Problem problem = valley();
  problem.start = Vector{{0.5, -1, 2}};
  problem.start_scales = {1, 10};
  for (int number = 1; number <= 6; ++number) {
    const Problem moved = instance(problem, number);
    const double scale = number % 2 == 1 ? 1 : 10;
    EXPECT_NEAR(moved.evaluate(moved.start).objective,
                problem.evaluate(scale * problem.start).objective, 1e-8 * scale * scale);
    EXPECT_TRUE(is_inside(moved, moved.start));
  }
}

TEST(Instance, KeepsTheSmoothing) {
  Problem problem = parabola(2);
  problem.smoothed = [problem](double smoothing) {
    Problem smooth = problem;
    smooth.evaluate = [smoothing](const Vector& x) {
      return Values{(x.array() - 0.25).square().sum() + smoothing, {}};
    };
    return smooth;
  };
  const Problem moved = instance(problem, 3);
  const Problem smooth = moved.smoothed(0.5);
  EXPECT_EQ(smooth.lower, moved.lower);
  EXPECT_NEAR(smooth.evaluate(moved.start).objective, moved.evaluate(moved.start).objective + 0.5,
              1e-12);
}

/// As a shell does, but for a problem that may hang or crash: that one is named.
TEST(Instance, IsOfAProblemThatAPatternChooses) {
  Problem problem = parabola(1);
  problem.name = "ill-1";
  EXPECT_TRUE(is_chosen(problem, {"well-*", "*-1"}));
  EXPECT_FALSE(is_chosen(problem, {"well-*"}));
  problem.hazardous = true;
  EXPECT_FALSE(is_chosen(problem, {"*", "*-1", "?ll-1", "well-*"}));
  EXPECT_TRUE(is_chosen(problem, {"*", "ill-*"}));
  EXPECT_TRUE(is_chosen(problem, {"ill-1"}));
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
