#include "problems/classic/least_squares.h"

#include <Eigen/QR>

#include "src/core/instance.h"
#include "tests/problems/classic/claims.h"
#include "tests/support/test.h"

namespace ricochet::classic {
namespace {

TEST(LeastSquares, HasTheSumsPublishedForStartsAndOptima) {
  const std::vector<Problem> problems = least_squares_problems();
  const auto rows = lines_published("published_values.csv", "least-squares-");
  ASSERT_EQ(problems.size(), rows.size());
  EXPECT_EQ(rows.size(), 53U);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    EXPECT_EQ(problems[i].name, rows[i][0]);
    const double least = std::stod(rows[i][1]), start = std::stod(rows[i][3]);
    EXPECT_NEAR(2 * problems[i].evaluate(problems[i].start).objective, start, 6e-7 * start)
        << problems[i].name;
    const double digits = least < 1e-5 ? 5e-7 : 1e-10;  // 7 are given of the two smallest
    EXPECT_NEAR(2 * *problems[i].best_known, least, digits * least) << problems[i].name;
  }
}

TEST(LeastSquares, IsFiniteAllOverItsBox) {
  for (const Problem& problem : least_squares_problems()) {
    Random random(seed_of(problem.name, "finite", 0, 0));
    for (int i = 0; i < 100; ++i) {
      // Corners, with the chance of any other point in every coordinate.
      Vector x = uniform_point(problem, random);
      for (Eigen::Index k = 0; k < x.size(); ++k) {
        const auto draw = std::uniform_int_distribution<int>(0, 2)(random);
        if (draw < 2) x[k] = draw == 0 ? problem.lower[k] : problem.upper[k];
      }
      EXPECT_TRUE(std::isfinite(problem.evaluate(x).objective)) << problem.name;
    }
  }
}

TEST(LeastSquares, HasTheJacobianOfDifferences) {
  for (const Problem& problem : least_squares_problems()) {
    SCOPED_TRACE(problem.name);
    Random random(seed_of(problem.name, "residuals", 0, 0));
    const Vector x = point_near_best(problem, random);
    const Residuals r = problem.residuals(x);
    expect_columns(
        problem, x, r.jacobian, [&](const Vector& y) { return problem.residuals(y).values; }, 1e-5);
    const Derivatives d = problem.differentiate(x);
    EXPECT_EQ(d.values.objective, r.values.squaredNorm() / 2);
    EXPECT_EQ(d.values.objective, problem.evaluate(x).objective);
    EXPECT_EQ(d.gradient, r.jacobian.transpose() * r.values);
  }
}

TEST(LeastSquares, HasTheOptimumOfLinearAlgebraWhereItIsLinear) {
  const std::vector<Problem> problems = least_squares_problems();
  for (std::size_t i = 0; i < 6; ++i) {
    const Residuals r = problems[i].residuals(Vector::Zero(problems[i].dimension()));
    const auto decomposition = r.jacobian.completeOrthogonalDecomposition();
    EXPECT_EQ(decomposition.rank(), i < 2 ? 9 : 1);
    const Vector nearest = decomposition.solve(-r.values);
    EXPECT_NEAR((r.values + r.jacobian * nearest).squaredNorm() / 2, *problems[i].best_known,
                1e-12);
    EXPECT_LT((nearest - *problems[i].best_point).norm(), 1e-12);
  }
}

TEST(LeastSquares, FreudensteinAndRothHasAPublishedSecondMinimum) {
  const Problem problem = named(least_squares_problems(), "least-squares-13-freudenstein-roth-2x2");
  const Derivatives d = problem.differentiate(Vector{{11.4127789919, -0.8968052560}});
  EXPECT_NEAR(2 * d.values.objective, 48.98425, 5e-6);
  EXPECT_LT(d.gradient.norm(), 1e-5);
}

TEST(LeastSquares, IsStationaryAtItsBestPoint) {
  for (const Problem& problem : least_squares_problems()) {
    const Residuals r = problem.residuals(*problem.best_point);
    // The cosine between the residuals and every column, or no residuals.
    for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
      const double slope = std::abs(r.jacobian.col(i).dot(r.values));
      EXPECT_LE(slope, 1e-9 * r.jacobian.col(i).norm() * (r.values.norm() + 1)) << problem.name;
    }
  }
}

}  // namespace
}  // namespace ricochet::classic
