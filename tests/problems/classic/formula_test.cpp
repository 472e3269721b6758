#include "problems/classic/formula.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/classic/classic.h"
#include "ricochet/random.h"
#include "src/core/instance.h"

namespace ricochet::classic {
namespace {

Statement box(Eigen::Index n) {
  return {.name = "box",
          .lower = Vector::Zero(n),
          .upper = Vector::Ones(n),
          .start = Vector::Constant(n, 3),
          .best_point = Vector::Zero(n)};
}

TEST(Formula, MovesAStartOutsideTheBoxToItsNearestPoint) {
  Statement statement = box(3);
  statement.start = Vector{{-2, 0.5, 7}};
  EXPECT_EQ(without_functions(statement).start, (Vector{{0, 0.5, 1}}));
}

TEST(Formula, IsDifferentiatedInAnyNumberOfVariables) {
  for (Eigen::Index n = 1; n <= 9; ++n) {
    const Problem problem = from_formula(box(n), []<class Scalar>(const Point<Scalar>& x) {
      Scalar sum(0);
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        sum += static_cast<double>(i + 1) * x[i] * x[i] * x[i];
      }
      return sum;
    });
    const Vector x = Vector::LinSpaced(n, 0.2, 0.8);
    const Vector weights = Vector::LinSpaced(n, 1, static_cast<double>(n));
    const Derivatives d = problem.differentiate(x);
    EXPECT_NEAR(d.values.objective, weights.dot(x.array().cube().matrix()), 1e-14);
    EXPECT_LT((d.gradient - 3 * weights.cwiseProduct(x.cwiseAbs2())).norm(), 1e-13);
    EXPECT_EQ(d.jacobian.rows(), 0);
    EXPECT_EQ(d.jacobian.cols(), n);
  }
}

TEST(Formula, TakesConstraintsOneByOneOrTogether) {
  const auto sum = []<class Scalar>(const Point<Scalar>& x) { return x.sum(); };
  const Vector x{{0.5, 0.25}};
  const Problem one = from_formulas(
      box(2), sum, []<class Scalar>(const Point<Scalar>& y) { return y[0] * y[1] - 1.0; });
  EXPECT_EQ(one.constraints, 1);
  EXPECT_EQ(one.evaluate(x).constraints, Vector::Constant(1, -0.875));
  EXPECT_EQ(one.differentiate(x).jacobian, (Matrix{{0.25, 0.5}}));
  const Problem two = from_formulas(box(2), sum, []<class Scalar>(const Point<Scalar>& y) {
    return std::array<Scalar, 2>{y[0] * y[0], 3.0 * y[1]};
  });
  EXPECT_EQ(two.constraints, 2);
  EXPECT_EQ(two.evaluate(x).constraints, (Vector{{0.25, 0.75}}));
  EXPECT_EQ(two.differentiate(x).jacobian, (Matrix{{1, 0}, {0, 3}}));
  EXPECT_EQ(two.differentiate(x).gradient, Vector::Ones(2));
}

TEST(Formula, HalvesTheSumOfSquaresOfResiduals) {
  const Problem problem = from_residuals(box(2), []<class Scalar>(const Point<Scalar>& x) {
    return std::array<Scalar, 3>{x[0] - 1.0, x[0] * x[1], 2.0 * x[1]};
  });
  const Vector x{{3, 2}};
  EXPECT_EQ(problem.evaluate(x).objective, (4 + 36 + 16) / 2.0);
  const Residuals r = problem.residuals(x);
  EXPECT_EQ(r.values, (Vector{{2, 6, 4}}));
  EXPECT_EQ(r.jacobian, (Matrix{{1, 0}, {2, 3}, {0, 2}}));
  EXPECT_EQ(problem.differentiate(x).gradient, (Vector{{2 + 12, 18 + 8}}));
  EXPECT_EQ(problem.differentiate(x).values.objective, 28);
}

TEST(Formula, HasTheSecondDerivativesThatDifferencesOfTheFirstHave) {
  std::size_t checked = 0;
  for (const Family& family : families()) {
    for (const Problem& problem : family.problems) {
      ASSERT_EQ(!problem.lagrangian_hessian, !problem.differentiate) << problem.name;
      if (!problem.differentiate) continue;
      Random random(seed_of(problem.name, "Hessian", 0, 0));
      const Eigen::Index n = problem.dimension();
      // Near the best point, where every formula is defined.
      const Vector width = problem.upper - problem.lower;
      const Vector near = 0.98 * *problem.best_point + 0.02 * uniform_point(problem, random);
      const Vector multipliers =
          Vector::NullaryExpr(problem.constraints, [&] { return 2 * uniform(random) - 1; });
      const auto slope = [&](const Vector& x) -> Vector {
        const Derivatives d = problem.differentiate(x);
        return 0.7 * d.gradient + d.jacobian.transpose() * multipliers;
      };
      const Matrix hessian = problem.lagrangian_hessian(near, 0.7, multipliers);
      if (!hessian.allFinite()) continue;
      Matrix differences(n, n);
      for (Eigen::Index i = 0; i < n; ++i) {
        const double step = 1e-5 * std::max(std::abs(near[i]), 1e-2 * width[i]);
        const Vector shift = step * Vector::Unit(n, i);
        // Richardson's extrapolation of central differences: an error of the fourth order.
        differences.col(i) = (8 * (slope(near + shift) - slope(near - shift)) -
                              (slope(near + 2 * shift) - slope(near - 2 * shift))) /
                             (12 * step);
      }
      EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm() + 1e-300)
          << problem.name;
      EXPECT_LT((hessian - differences).norm(), 1e-5 * (hessian.norm() + 1e-9)) << problem.name;
      ++checked;
    }
  }
  EXPECT_GE(checked, 190U);
}

}  // namespace
}  // namespace ricochet::classic
