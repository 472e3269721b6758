#include "problems/classic/functions.h"

#include <Eigen/QR>

#include "problems/classic/least_squares.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

using std::numbers::e;
using std::numbers::pi;

double at(const Problem& problem, const Vector& x) {
  return problem.evaluate(x).objective;
}

TEST(Functions, HaveTheValuesWorkedByHand) {
  struct Worked {
    Problem problem;
    Vector x;
    double value;
    double tolerance = 1e-12;  ///< 0: exactly
  };
  const double wave = std::sin(1.0);
  const std::vector<Worked> all = {
      // Of one valley.
      {sphere(3), Vector{{1, 2, -3}}, 14, 0},
      {ellipsoid(3), Vector{{1, 2, 3}}, 1 + 4e3 + 9e6, 1e-6},
      {rosenbrock(2), Vector{{-1.2, 1}}, 24.2, 1e-13},  // published with the function
      {rosenbrock(3), Vector{{0, 1, 2}}, 100 + 1 + 100 + 0, 0},
      {zakharov(2), Vector{{1, 1}}, 2 + 2.25 + 5.0625, 0},
      {dixon_price(3), Vector{{0, 1, 1}}, 1 + 2 * 4 + 3, 0},
      {schwefel_1_2(3), Vector{{1, 2, -3}}, 1 + 9 + 0, 0},
      {powell_singular(), Vector{{3, -1, 0, 1}}, 215, 0},  // published
      {step(2), Vector{{0.49, -0.5}}, 0, 0},
      {step(2), Vector{{0.5, -0.5}}, 1, 0},
      {step(2), Vector{{1.5, -0.51}}, 4 + 1, 0},
      // Of many.
      {rastrigin(2), Vector{{1, -2}}, 5},
      {rastrigin(2), Vector{{0.5, 0}}, 20.25},
      {ackley(2), Vector{{1, 1}}, 20 - 20 * std::exp(-0.2)},
      {ackley(2), Vector{{0.5, 0.5}}, 20 - 20 * std::exp(-0.1) + e - 1 / e},
      {griewank(2), Vector{{pi, 0}}, 2 + pi * pi / 4000},
      {griewank(2), Vector{{0, pi * std::sqrt(2.0)}}, 2 + pi * pi / 2000},
      {levy(2), Vector{{5, 1}}, 1 + 10 * wave * wave},  // w = (2, 1)
      {levy(2), Vector{{1, 2}}, 2.0 / 16},              // w = (1, 5/4)
      {levy(2), Vector{{2, 1}},
       0.5 + (1 + 10 * std::pow(std::sin(1.25 * pi + 1), 2)) / 16},  // w = (5/4, 1)
      {styblinski_tang(2), Vector{{1, -1}}, -5 - 10, 0},
      {schwefel_2_26(2), Vector{{pi * pi / 4, 0}}, -pi * pi / 4},
      // In the plane.
      {beale(), Vector{{1, 1}}, 14.203125, 0},  // published
      {beale(), Vector{{0, 0}}, 1.5 * 1.5 + 2.25 * 2.25 + 2.625 * 2.625, 0},
      {booth(), Vector{{0, 0}}, 49 + 25, 0},
      {himmelblau(), Vector{{0, 0}}, 121 + 49, 0},
      {six_hump_camel(), Vector{{0, 1}}, 0, 0},
      {six_hump_camel(), Vector{{1, 0}}, 4 - 2.1 + 1.0 / 3},
      {branin(), Vector{{0, 6}}, 20 - 10 / (8 * pi)},
      // Published minima besides the best.
      {goldstein_price(), Vector{{-0.6, -0.4}}, 30, 1e-9},  // Goldstein and Price (1971)
      {goldstein_price(), Vector{{1.8, 0.2}}, 84, 1e-9},
      {goldstein_price(), Vector{{1.2, 0.8}}, 840, 1e-9},
      {himmelblau(), Vector{{-2.805118, 3.131312}}, 0, 1e-9},
      {himmelblau(), Vector{{-3.779310, -3.283186}}, 0, 1e-9},
      {himmelblau(), Vector{{3.584428, -1.848126}}, 0, 1e-9},
      {branin(), Vector{{-pi, 12.275}}, *branin().best_known},
      {branin(), Vector{{3 * pi, 2.475}}, *branin().best_known},
      {six_hump_camel(), -*six_hump_camel().best_point, *six_hump_camel().best_known, 1e-14},
      // Near (-1, 1, 1, 1): doi 10.1162/evco.2006.14.1.119.
      {rosenbrock(4), Vector{{-0.775659, 0.613093, 0.382063, 0.145973}}, 3.7014, 1e-3},
      {named(least_squares_problems(), "least-squares-13-freudenstein-roth-2x2"),
       Vector{{11.4127789919, -0.8968052560}}, 48.98425 / 2, 2.5e-6},
  };
  for (const auto& [problem, x, value, tolerance] : all) {
    EXPECT_NEAR(at(problem, x), value, tolerance) << problem.name << ' ' << x.transpose();
  }
}

TEST(Functions, HaveThePublishedOptima) {
  EXPECT_NEAR(*styblinski_tang(1).best_known, -39.16599, 3e-4);  // Styblinski and Tang (1990)
  EXPECT_NEAR((*styblinski_tang(1).best_point)[0], -2.903534, 1e-6);
  EXPECT_NEAR(*schwefel_2_26(1).best_known, -418.982887, 1e-6);  // Schwefel (1981)
  EXPECT_NEAR((*schwefel_2_26(1).best_point)[0], 420.968746, 1e-6);
  EXPECT_NEAR(*hartmann_3().best_known, -3.86278, 5e-6);  // Dixon and Szegoe (1978)
  EXPECT_NEAR(*hartmann_6().best_known, -3.32237, 5e-6);
  EXPECT_NEAR(*shekel().best_known, -10.5364, 5e-5);
  EXPECT_NEAR(*branin().best_known, 0.397887, 5e-7);
  EXPECT_NEAR(*six_hump_camel().best_known, -1.0316285, 5e-8);
}

TEST(Functions, AreStationaryAtTheirBestPoints) {
  for (const Problem& problem :
       {rastrigin(3), griewank(3), levy(3), styblinski_tang(3), schwefel_2_26(3), hartmann_3(),
        hartmann_6(), shekel(), beale(), booth(), himmelblau(), goldstein_price(), branin(),
        six_hump_camel()}) {
    EXPECT_LT(problem.differentiate(*problem.best_point).gradient.norm(), 1e-12) << problem.name;
  }
  for (const Problem& problem : {ackley(2), schwefel_2_26(2)}) {  // where the formula has no slope
    EXPECT_EQ(problem.differentiate(Vector::Zero(2)).gradient, Vector::Zero(2));
  }
}

TEST(Functions, OfOneValleyDoNotHaveTheOptimumAtTheCentre) {
  for (const Problem& problem : {sphere(2), ellipsoid(2), rosenbrock(2), zakharov(2),
                                 dixon_price(2), schwefel_1_2(2), powell_singular(), step(2)}) {
    EXPECT_GT(at(problem, (problem.lower + problem.upper) / 2), 0.1) << problem.name;
  }
}

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
      // Points of the box thrice as wide, moved into it: mostly corners and edges.
      const Vector aside = 3 * uniform_point(problem, random) - problem.lower - problem.upper;
      const Vector x = aside.cwiseMax(problem.lower).cwiseMin(problem.upper);
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
    const auto residuals = [&](const Vector& y) { return problem.residuals(y).values; };
    expect_columns(problem, x, r.jacobian, residuals, 1e-5);
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
