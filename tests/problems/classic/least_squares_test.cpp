#include "problems/classic/least_squares.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <set>

#include "src/core/instance.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

/// The sums of squares that are published for a problem.
struct Published {
  const char* name;  ///< after the number
  double at_start;
  double least;
};

// Sources: at the starts data/testout.dat of github.com/POptUS/BenDFO and benchmarking/more_wild.py
// of github.com/optimagic-dev/optimagic, which agree to their digits; the least of the latter and,
// for functions of theirs, of More, Garbow and Hillstrom (1981). For Freudenstein and Roth the
// former gives the second minimum, 48.98; here is the least, 0.
const std::vector<Published>& published() {
  static const std::vector<Published> sums = {
      {"linear-full-rank-9x45", 72, 36},
      {"linear-full-rank-9x45-far", 1125, 36},
      {"linear-rank-1-7x35", 1.165420e7, 8.380281690143324},
      {"linear-rank-1-7x35-far", 1.168591e9, 8.380281690143324},
      {"linear-rank-1-with-zeros-7x35", 4.989195e6, 9.880597014926506},
      {"linear-rank-1-with-zeros-7x35-far", 5.009356e8, 9.880597014926506},
      {"rosenbrock-2x2", 24.2, 0},
      {"rosenbrock-2x2-far", 1.795769e6, 0},
      {"helical-valley-3x3", 2500, 0},
      {"helical-valley-3x3-far", 10600, 0},
      {"powell-singular-4x4", 215, 0},
      {"powell-singular-4x4-far", 1.615400e6, 0},
      {"freudenstein-roth-2x2", 400.5, 0},
      {"freudenstein-roth-2x2-far", 1.545754e8, 0},
      {"bard-3x15", 41.68170, 0.00821487730657897},
      {"bard-3x15-far", 1306.234, 0.00821487730657897},
      {"kowalik-osborne-4x11", 5.313172e-3, 0.00030750560384924},
      {"meyer-3x16", 1.693608e9, 87.945855170395831},
      {"watson-6x31", 16.43083, 0.00228767005355236},
      {"watson-6x31-far", 2.323367e6, 0.00228767005355236},
      {"watson-9x31", 26.90417, 1.399760e-6},
      {"watson-9x31-far", 8.158877e6, 1.399760e-6},
      {"watson-12x31", 73.67821, 4.722381e-10},
      {"watson-12x31-far", 2.059384e7, 4.722381e-10},
      {"box-3d-3x10", 1031.154, 0},
      {"jennrich-sampson-2x10", 4171.306, 124.3621823556148},
      {"brown-dennis-4x20", 7.926693e6, 85822.20162635},
      {"brown-dennis-4x20-far", 3.081064e11, 85822.20162635},
      {"chebyquad-6x6", 4.642817e-2, 0},
      {"chebyquad-7x7", 3.377064e-2, 0},
      {"chebyquad-8x8", 3.861770e-2, 0.003516873725677},
      {"chebyquad-9x9", 2.888298e-2, 0},
      {"chebyquad-10x10", 3.376327e-2, 0.00477271369637536},
      {"chebyquad-11x11", 2.674060e-2, 0.00279976155186576},
      {"brown-almost-linear-10x10", 273.2480, 0},
      {"osborne-1-5x33", 16.17411, 0.00005464894697483},
      {"osborne-2-11x65", 2.093420, 0.0401377362935477},
      {"osborne-2-11x65-far", 199.6847, 0.0401377362935477},
      {"bdqrtic-8x8", 904, 10.2389734213174},
      {"bdqrtic-10x12", 1356, 18.28116175359353},
      {"bdqrtic-11x14", 1582, 22.260591734883817},
      {"bdqrtic-12x16", 1808, 26.2727663967939},
      {"cube-5x5", 56.5, 0},
      {"cube-6x6", 70.5625, 0},
      {"cube-8x8", 98.6875, 0},
      {"mancino-5x5", 2.539084e9, 0},
      {"mancino-5x5-far", 6.873795e12, 0},
      {"mancino-8x8", 3.367961e9, 0},
      {"mancino-10x10", 3.735127e9, 0},
      {"mancino-12x12", 3.991072e9, 0},
      {"mancino-12x12-far", 1.130015e13, 0},
      {"heart-8-8x8", 9.385672, 0},
      {"heart-8-8x8-far", 3.365815e10, 0},
  };
  return sums;
}

TEST(LeastSquares, HasTheSumsPublishedForStartsAndOptima) {
  const std::vector<Problem> problems = least_squares_problems();
  ASSERT_EQ(problems.size(), 53u);
  ASSERT_EQ(published().size(), 53u);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Published& p = published()[i];
    const double at_start = 2 * problems[i].evaluate(problems[i].start).objective;
    EXPECT_NEAR(at_start, p.at_start, 6e-7 * p.at_start) << p.name;
    const double digits = p.least < 1e-5 ? 5e-7 : 1e-10;  // 7 are given of the two smallest
    EXPECT_NEAR(2 * *problems[i].best_known, p.least, digits * p.least) << p.name;
  }
}

TEST(LeastSquares, IsNamedByNumberFunctionAndSize) {
  const std::vector<Problem> problems = least_squares_problems();
  EXPECT_EQ(problems.front().name, "least-squares-01-linear-full-rank-9x45");
  std::set<std::string> names;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    names.insert(problems[i].name);
    EXPECT_EQ(problems[i].name.substr(17), published()[i].name);
  }
  EXPECT_EQ(names.size(), 53u);
}

TEST(LeastSquares, StatesWhatItIs) {
  for (const Problem& problem : least_squares_problems()) expect_statement(problem);
}

TEST(LeastSquares, HasNoRandomPointBelowTheBest) {
  for (const Problem& problem : least_squares_problems()) expect_nothing_better(problem);
}

TEST(LeastSquares, KeepsTheBestInInstances) {
  for (const Problem& problem : least_squares_problems()) expect_best_in_instances(problem);
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
