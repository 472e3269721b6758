#include <gtest/gtest.h>

#include "src/core/evaluator.h"
#include "tests/core/hessian_check.h"

namespace ricochet {
namespace {

/// x0^2 + x1 subject to 1 - x0 <= 0 and x1 - 2 <= 0.
Problem constrained() {
  Problem problem;
  problem.name = "constrained";
  problem.lower = Vector::Constant(2, -5);
  problem.upper = Vector::Constant(2, 5);
  problem.start = Vector::Zero(2);
  problem.constraints = 2;
  problem.best_known = -4.0;
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[0] + x[1], Vector{{1 - x[0], x[1] - 2}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector{{2 * x[0], 1.0}}, Matrix{{-1.0, 0.0}, {0.0, 1.0}}};
  };
  return problem;
}

TEST(Penalty, AddsNothingWhereTheConstraintsHold) {
  const Problem problem = penalised(constrained(), 10);
  EXPECT_EQ(problem.constraints, 0);
  EXPECT_EQ(problem.best_known, -4.0);
  EXPECT_EQ(problem.evaluate(Vector{{2.0, 1.0}}).objective, 5.0);
  EXPECT_EQ(problem.evaluate(Vector{{2.0, 1.0}}).constraints.size(), 0);
}

TEST(Penalty, AddsTheWeightedSumOfTheViolations) {
  const Problem problem = penalised(constrained(), 10);
  EXPECT_EQ(problem.evaluate(Vector{{-1.0, 4.0}}).objective, 5.0 + 10 * (2.0 + 2.0));
}

TEST(Penalty, HasTheGradientOfItsValues) {
  const Problem problem = penalised(constrained(), 10);
  for (const Vector& x : {Vector{{2.0, 1.0}}, Vector{{-1.0, 4.0}}, Vector{{0.5, 0.0}}}) {
    const Derivatives d = problem.differentiate(x);
    EXPECT_EQ(d.values.objective, problem.evaluate(x).objective);
    for (Eigen::Index i = 0; i < 2; ++i) {
      const double h = 1e-5;
      const Vector step = h * Vector::Unit(2, i);
      const double slope =
          (problem.evaluate(x + step).objective - problem.evaluate(x - step).objective) / (2 * h);
      EXPECT_NEAR(d.gradient[i], slope, 1e-6);
    }
  }
}

/// The same with constraints that bend, and their second derivatives.
Problem with_bent_constraints() {
  Problem problem = constrained();
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[0] + x[1], Vector{{1 - x[0] * x[0] * x[1], x[1] * x[1] - 2}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector{{2 * x[0], 1.0}},
                       Matrix{{-2 * x[0] * x[1], -x[0] * x[0]}, {0.0, 2 * x[1]}}};
  };
  problem.lagrangian_hessian = [](const Vector& x, double factor, const Vector& multipliers) {
    const double mixed = -2 * x[0] * multipliers[0];
    return Matrix{{2 * factor - 2 * x[1] * multipliers[0], mixed}, {mixed, 2 * multipliers[1]}};
  };
  return problem;
}

TEST(Penalty, HasTheSecondDerivativesOfItsGradient) {
  Problem original = with_bent_constraints();
  for (const Eigen::Index equalities : {0, 1}) {
    original.equalities = equalities;
    const Problem problem = penalised(original, 10);
    for (const Vector& x : {Vector{{2.0, 1.0}}, Vector{{-1.0, 4.0}}, Vector{{0.5, 0.3}}}) {
      EXPECT_EQ(expect_hessian_of_gradients(problem, x, 0.7, Vector()), 4);
    }
  }
  EXPECT_FALSE(penalised(constrained(), 10).lagrangian_hessian);
}

TEST(Penalty, ChargesAnEquationForEitherSign) {
  Problem original = constrained();
  original.equalities = 1;  // x0 = 1
  const Problem problem = penalised(original, 10);
  EXPECT_EQ(problem.equalities, 0);
  for (const Vector& x : {Vector{{-1.0, 4.0}}, Vector{{3.0, 4.0}}}) {
    const Derivatives d = problem.differentiate(x);
    EXPECT_EQ(d.values.objective, x[0] * x[0] + x[1] + 10 * (2.0 + 2.0));
    EXPECT_EQ(d.gradient[0], 2 * x[0] + (x[0] > 1 ? 10 : -10));
    EXPECT_EQ(problem.true_values(x).violation, 2.0);
  }
}

TEST(Penalty, HasNoResiduals) {
  Problem original = constrained();
  original.residuals = [](const Vector&) { return Residuals{Vector::Ones(1), Matrix::Ones(1, 2)}; };
  EXPECT_FALSE(penalised(original, 10).residuals);
}

TEST(Penalty, IsJudgedByTheTrueValuesOfTheConstraints) {
  const TrueValues true_values = penalised(constrained(), 10).true_values(Vector{{-1.0, 4.0}});
  EXPECT_EQ(true_values.objective, 5.0);
  EXPECT_EQ(true_values.violation, 2.0);
}

TEST(Penalty, KeepsTheSmoothing) {
  Problem original = constrained();
  original.smoothed = [original](double smoothing) {
    Problem smooth = original;
    smooth.evaluate = [smoothing](const Vector&) {
      return Values{1.0, Vector::Constant(1, smoothing)};
    };
    return smooth;
  };
  const Problem smooth = penalised(original, 10).smoothed(0.5);
  EXPECT_EQ(smooth.evaluate(Vector::Zero(2)).objective, 6.0);
}

TEST(Penalty, KeepsATrueValuesOfTheProblemsOwn) {
  Problem original = constrained();
  original.true_values = [](const Vector&) { return TrueValues{7.0, 3.0}; };
  EXPECT_EQ(penalised(original, 10).true_values(Vector::Zero(2)).objective, 7.0);
}

}  // namespace
}  // namespace ricochet
