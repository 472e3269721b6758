#include "src/core/instance.h"

#include "tests/core/hessian_check.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

bool is_inside(const Problem& problem, const Vector& x) {
  return (x.array() >= problem.lower.array()).all() && (x.array() <= problem.upper.array()).all();
}

/// Where in its box, from 0 to 1, instances 1 to 40 of a problem have their best point's first
/// coordinate.
std::vector<double> places_of_best_points(const Problem& problem) {
  std::vector<double> places;
  for (int number = 1; number <= 40; ++number) {
    const Problem moved = instance(problem, number);
    EXPECT_TRUE(is_inside(moved, moved.start) && is_inside(moved, *moved.best_point));
    places.push_back(((*moved.best_point)[0] - moved.lower[0]) / (moved.upper[0] - moved.lower[0]));
  }
  return places;
}

void expect_spread(const std::vector<double>& places, double least, double most, double below,
                   double above) {
  const auto [lowest, highest] = std::ranges::minmax(places);
  EXPECT_GE(lowest, least);
  EXPECT_LT(lowest, below);
  EXPECT_LE(highest, most);
  EXPECT_GT(highest, above);
}

TEST(Instance, ZeroIsTheProblemAsStatedAndNegativeOnesAreNone) {
  const Problem problem = parabola(2);
  const Problem same = instance(problem, 0);
  EXPECT_EQ(same.lower, problem.lower);
  EXPECT_EQ(same.evaluate(problem.start).objective, problem.evaluate(problem.start).objective);
  EXPECT_THROW(instance(parabola(1), -1), std::invalid_argument);
}

TEST(Instance, MovesTheOptimumWithinTheBoxAndReflectsIt) {
  expect_spread(places_of_best_points(parabola(1)), 0, 1, 0.15, 0.85);
  for (int number = 1; number <= 40; ++number) {
    const Problem moved = instance(parabola(1), number);
    const double width = moved.upper[0] - moved.lower[0];
    EXPECT_GE(width, 0.5);
    EXPECT_LE(width, 1);
    EXPECT_NEAR(moved.evaluate(*moved.best_point).objective, 0.0, 1e-12);
  }
}

TEST(Instance, StaysWithinTheBoxOfAProblemThatIsNotDefinedOutside) {
  Problem problem = parabola(2);
  problem.evaluate = [problem](const Vector& x) {
    EXPECT_TRUE(is_inside(problem, x));
    return problem.evaluate(x);
  };
  for (int number = 1; number <= 20; ++number) {
    const Problem moved = instance(problem, number);
    for (const Vector& corner : {moved.lower, moved.upper}) moved.evaluate(corner);
    EXPECT_TRUE(is_inside(moved, *moved.best_point));
  }
}

/// A problem with its best point at an end of its box, beyond which it is its mirror image.
Problem bowl(Eigen::Index n) {
  Problem problem = parabola(n);
  problem.name = "bowl";
  problem.mirrors = true;
  problem.best_point = Vector::Zero(n);
  const auto check = [](const Vector& x) {
    EXPECT_TRUE((x.array() >= 0).all() && (x.array() <= 1).all());
  };
  problem.evaluate = [check](const Vector& x) {
    check(x);
    return Values{x.squaredNorm(), {}};
  };
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * x; });
  return problem;
}

TEST(Instance, MovesABestPointOffTheEndBeyondWhichTheProblemIsMirrored) {
  expect_spread(places_of_best_points(bowl(2)), 0.1 - 1e-12, 0.9 + 1e-12, 0.25, 0.75);
  for (int number = 1; number <= 40; ++number) {
    EXPECT_EQ(instance(bowl(2), number).evaluate(*instance(bowl(2), number).best_point).objective,
              0);
  }
}

/// Both are the square of the distance from their best point, wherever that is moved.
TEST(Instance, KeepsDerivativesAndResidualsConsistent) {
  for (const Problem& problem : {bowl(2), parabola(3)}) {
    for (int number = 1; number <= 40; ++number) {
      const Problem moved = instance(problem, number);
      for (const Vector& x : {moved.lower, moved.upper, moved.start}) {
        const Vector way = x - *moved.best_point;
        EXPECT_NEAR(moved.evaluate(x).objective, way.squaredNorm(), 1e-12);
        EXPECT_LT((moved.differentiate(x).gradient - 2 * way).norm(), 1e-12);
        if (problem.name == "bowl") continue;
        const Residuals r = moved.residuals(x);
        EXPECT_NEAR(r.values.squaredNorm() / 2, way.squaredNorm(), 1e-12);
        EXPECT_LT((r.jacobian.transpose() * r.values - 2 * way).norm(), 1e-12);
      }
    }
  }
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

TEST(Instance, KeepsTheBoxWhereNoBestPointIsKnown) {
  Problem problem = parabola(1);
  problem.best_point.reset();
  const Problem moved = instance(problem, 1);
  EXPECT_NEAR(moved.upper[0] - moved.lower[0], 1, 1e-12);
}

/// A valley that no axis follows, with a bump outside the box on the side away from its best point.
Problem valley() {
  Problem problem = parabola(3);
  problem.name = "valley";
  problem.rotates = true;
  const Vector steepness{{1, 10, 100}};
  problem.evaluate = [steepness](const Vector& x) {
    return Values{(steepness.array() * (x.array() - 0.25).square()).sum(), {}};
  };
  differentiate_by(problem, [steepness](const Vector& x) -> Vector {
    return 2 * steepness.array() * (x.array() - 0.25);
  });
  problem.residuals = [steepness](const Vector& x) {
    const Vector root = (2 * steepness).cwiseSqrt();
    return Residuals{root.array() * (x.array() - 0.25), root.asDiagonal()};
  };
  return problem;
}

TEST(Instance, KnowsItsPointsInTheProblemAsStated) {
  for (const Problem& problem : {parabola(3), bowl(3), valley()}) {
    for (int number = 0; number <= 10; ++number) {
      const Problem moved = instance(problem, number);
      for (const Vector& x : {moved.lower, moved.upper, moved.start, *moved.best_point}) {
        const Vector stated = stated_point(problem, number, x);
        EXPECT_EQ(problem.evaluate(stated).objective, moved.evaluate(x).objective);
      }
      const Vector best = stated_point(problem, number, *moved.best_point);
      EXPECT_LT((best - *problem.best_point).norm(), 1e-12);
    }
  }
}

TEST(Instance, TurnsAProblemAboutItsBestPoint) {
  for (int number = 1; number <= 10; ++number) {
    const Problem moved = instance(valley(), number);
    EXPECT_LT(moved.evaluate(*moved.best_point).objective, 1e-12);
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
    const Derivatives d = moved.differentiate(moved.start);
    const Residuals r = moved.residuals(moved.start);
    EXPECT_LT((r.jacobian.transpose() * r.values - d.gradient).norm(), 1e-11);
    EXPECT_NEAR(r.values.squaredNorm() / 2, d.values.objective, 1e-11);
  }
}

/// Curved in all directions, as are its equation and its inequality.
Problem bent() {
  Problem problem = parabola(3);
  problem.name = "bent";
  problem.constraints = 2;
  problem.equalities = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[0] * x[1] + std::exp(x[2]),
                  Vector{{x[1] * x[2] * x[2], std::sin(x[0] * x[2])}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    const double slope = std::cos(x[0] * x[2]);
    return Derivatives{evaluate(x), Vector{{2 * x[0] * x[1], x[0] * x[0], std::exp(x[2])}},
                       Matrix{{0, x[2] * x[2], 2 * x[1] * x[2]}, {x[2] * slope, 0, x[0] * slope}}};
  };
  problem.lagrangian_hessian = [](const Vector& x, double factor, const Vector& multipliers) {
    const double a = x[0], b = x[1], c = x[2];
    const double sine = std::sin(a * c);
    const double mixed = std::cos(a * c) - a * c * sine;
    const Matrix of_objective{{2 * b, 2 * a, 0}, {2 * a, 0, 0}, {0, 0, std::exp(c)}};
    const Matrix of_equation{{0, 0, 0}, {0, 0, 2 * c}, {0, 2 * c, 2 * b}};
    const Matrix of_inequality{{-c * c * sine, 0, mixed}, {0, 0, 0}, {mixed, 0, -a * a * sine}};
    return Matrix(factor * of_objective + multipliers[0] * of_equation +
                  multipliers[1] * of_inequality);
  };
  return problem;
}

TEST(Instance, KeepsTheSecondDerivativesConsistentHoweverItIsMovedReflectedAndTurned) {
  Random random(1);
  for (const bool rotates : {false, true}) {
    Problem problem = bent();
    problem.rotates = rotates;
    int compared = 0;
    for (int number = 0; number <= 10; ++number) {
      const Problem moved = instance(problem, number);
      const Vector x = moved.lower + 0.5 * (moved.upper - moved.lower);
      compared += expect_hessian_of_gradients(moved, x, uniform(random), normal(2, random));
    }
    EXPECT_GT(compared, 90);
  }
  EXPECT_FALSE(instance(parabola(2), 1).lagrangian_hessian) << "which has none";
}

TEST(Instance, MovesTheBoxAtWillWhereTheProblemIsDefinedOutside) {
  expect_spread(places_of_best_points(valley()), 0.1 - 1e-12, 0.9 + 1e-12, 0.2, 0.8);
  for (int number = 1; number <= 40; ++number) {
    const Problem moved = instance(valley(), number);
    EXPECT_NEAR((moved.upper - moved.lower).minCoeff(), 1, 1e-12);
  }
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

TEST(Instance, DependsOnNameAndNumberOnly) {
  EXPECT_EQ(instance(parabola(2), 3).lower, instance(parabola(2), 3).lower);
  EXPECT_NE(instance(parabola(2), 3).lower, instance(parabola(2), 4).lower);
  Problem other = parabola(2);
  other.name = "other";
  EXPECT_NE(instance(parabola(2), 3).lower, instance(other, 3).lower);
}

}  // namespace
}  // namespace ricochet
