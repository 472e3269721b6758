// Random search, scan, bisection, golden section, continuation, and the trust region of Ceres.

#include "solvers/library_solvers.h"
#include "src/core/instance.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

TEST(RandomSearch, BeginsAtTheStartAndThenFillsTheBoxEvenly) {
  const Problem problem = box_problem("even", 2, -4, 12, 1, [](const Vector&) { return 0.0; });
  const std::vector<Vector> asked = asked_points(problem, random_search(), 4001, 0);
  ASSERT_EQ(asked.size(), 4001U);
  EXPECT_EQ(asked.front(), problem.start);
  Eigen::Matrix4i tally = Eigen::Matrix4i::Zero();  // 16 cells of 4 x 4
  for (std::size_t k = 1; k < asked.size(); ++k) {
    const Vector cell = ((asked[k].array() + 4) / 4).floor();
    ++tally(static_cast<int>(cell[0]), static_cast<int>(cell[1]));
  }
  // 250 expected in each, give or take five standard deviations of 15.3.
  EXPECT_GT(tally.minCoeff(), 250 - 77);
  EXPECT_LT(tally.maxCoeff(), 250 + 77);
}

TEST(Scan, IsAnEvenGridAfterAPowerOfTwoAndOneEvaluations) {
  std::vector<double> mirrored;
  for (std::uint64_t k = 0; k < 9; ++k) mirrored.push_back(van_der_corput(k));
  EXPECT_THAT(mirrored, ElementsAre(0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875, 0.0625));
  const Problem problem = box_problem("even", 1, 2, 18, 9, [](const Vector&) { return 0.0; });
  std::vector<double> asked, grid(17);
  for (const Vector& x : asked_points(problem, scan(), 17, 0)) asked.push_back(x[0]);
  std::iota(grid.begin(), grid.end(), 2);
  EXPECT_THAT(asked, testing::UnorderedElementsAreArray(grid));
}

TEST(Bisection, HalvesTheIntervalAndHandsOverAFeasiblePointAtTheLimit) {
  for (const int halvings : {12, 37}) {  // after both ends and the start
    const RunRecord record = run(limited(7), bisection(), {2 + 1 + halvings}, 0);
    ASSERT_TRUE(record.returned);
    EXPECT_NEAR(record.returned->x[0], 7, std::max(1e-6, 18 * std::ldexp(1, -halvings)));
    EXPECT_EQ(record.returned->true_values.violation, 0);
  }
  Problem problem = limited(7);
  problem.best_point = Vector::Constant(1, 7);
  for (int number = 1; number <= 10; ++number) {  // some of whose boxes are reflected
    EXPECT_NEAR(end_of(instance(problem, number), bisection(), 40), -7, 1e-5) << number;
  }
}

TEST(GoldenSection, ShrinksTheIntervalByItsRatioAtEveryPoint) {
  // After the first few the interval is 200 * 0.618^k at most.
  const RunRecord record = run(sphere(1, 3), golden_section(), {30}, 0);
  EXPECT_NEAR(record.trace.back().x[0], 3, 1e-2);
  const RunRecord longer = run(sphere(1, 3), golden_section(), {60}, 0);
  EXPECT_EQ(longer.terminations.front().reason, "the interval is short");
  EXPECT_NEAR(longer.returned->x[0], 3, 1e-4);
}

/// The fastest x in [0, 18] at which a staircase, 5 up to x = 8 and 5 + rise beyond, is below 7.5;
/// its smooth formulation is a logistic in ln(x / 8).
Problem step_problem(double rise, double smoothing) {
  Problem problem = box_problem("step", 1, 0.01, 18, 15, [](const Vector& x) { return -x[0]; });
  problem.constraints = 1;
  const auto count = [rise, smoothing](double x) {
    if (smoothing == 0) return 5 + (x > 8 ? rise : 0);
    return 5 + rise / (1 + std::pow(x / 8, -1 / smoothing));
  };
  problem.evaluate = [count](const Vector& x) {
    return Values{-x[0], Vector::Constant(1, count(x[0]) - 7.5)};
  };
  problem.differentiate = [count, rise, smoothing, evaluate = problem.evaluate](const Vector& x) {
    const double share = (count(x[0]) - 5) / rise;
    const double slope = rise * share * (1 - share) / (smoothing * x[0]);
    return Derivatives{evaluate(x), Vector::Constant(1, -1.0), Matrix::Constant(1, 1, slope)};
  };
  problem.true_values = [rise](const Vector& x) {
    return TrueValues{-x[0], x[0] > 8 ? std::max(0.0, rise - 2.5) : 0.0};
  };
  problem.smoothed = [rise](double narrower) { return step_problem(rise, narrower); };
  return problem;
}

TEST(Continuation, FindsTheEndOfAPlateauThatItsSolverMisses) {
  for (const double rise : {3.0, 4.0, 8.0}) {  // 7.5 is passed too late, or too early
    const Problem problem = step_problem(rise, 0.25);
    for (const char* name : {"nlopt-slsqp", "ipopt-tuned"}) {
      const Solver solver = solver_named(name);
      EXPECT_GT(std::abs(end_of(problem, solver, 400) + 8), 0.1) << name << " " << rise;
      EXPECT_NEAR(end_of(problem, continuation(solver), 400), -8, 1e-3) << name << " " << rise;
    }
  }
}

TEST(Continuation, GoesFromWideToNarrowAndLooksAtTheTrueValuesLast) {
  std::vector<double> smoothings;
  Problem problem = step_problem(3, 0.25);
  problem.smoothed = [&smoothings](double smoothing) {
    smoothings.push_back(smoothing);
    return step_problem(3, smoothing);
  };
  solved(problem, continuation(solver_named("nlopt-slsqp")), 1000, 1);
  ASSERT_GT(smoothings.size(), 5U);
  EXPECT_EQ(smoothings.front(), 0.3);
  EXPECT_EQ(smoothings.back(), 0.0);
  EXPECT_TRUE(std::is_sorted(smoothings.rbegin(), smoothings.rend()));
}

/// A problem of two variables that is half the sum of the squares of `residuals`.
template <class Function>
Problem least_squares(const Vector& lower, const Vector& upper, const Vector& start,
                      Function residuals) {
  Problem problem = box_problem("least-squares", 2, 0, 0, 0, [residuals](const Vector& x) {
    return residuals(x).values.squaredNorm() / 2;
  });
  std::tie(problem.lower, problem.upper, problem.start) = std::tie(lower, upper, start);
  problem.residuals = residuals;
  return problem;
}

/// Half of Rosenbrock's function, Computer Journal 3 (1960) 175-184, from his start; `unit` is that
/// of the residuals. Without bounds the optimum is 0 at (1, 1).
Problem half_rosenbrock(const Vector& upper = Vector{{3, 4}}, double unit = 1) {
  return least_squares(Vector{{-2, -2}}, upper, Vector{{-1.2, 1.0}}.cwiseMin(upper),
                       [unit](const Vector& x) {
                         return Residuals{unit * Vector{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}},
                                          unit * Matrix{{-20 * x[0], 10.0}, {-1.0, 0.0}}};
                       });
}

Vector converged(const Problem& problem, std::int64_t budget) {
  const Solved end = solved(problem, ceres_least_squares(), budget);
  EXPECT_EQ(end.reason, "converged");
  return end.best->x;
}

TEST(CeresLeastSquares, FollowsACurvedValleyWhateverTheUnitOfTheResiduals) {
  for (const double unit : {1.0, 1e-6, 1e6}) {
    const Vector x = converged(half_rosenbrock(Vector{{3, 4}}, unit), unit == 1 ? 300 : 1000);
    EXPECT_LT((x - Vector{{1, 1}}).norm(), unit == 1 ? 1e-9 : 1e-6) << unit;
  }
}

TEST(CeresLeastSquares, GoesStraightToAnOptimumInACorner) {
  const Solved end = solved(sphere(2, 130), ceres_least_squares(), 300);
  EXPECT_EQ(end.reason, "converged");
  EXPECT_EQ(end.best->x, (Vector{{100, 100}}));
  EXPECT_EQ(end.ledger.derivatives, 3) << "it knows the bounds, but asks twice at the end";
}

TEST(CeresLeastSquares, FindsTheBestOfABoundThatEndsTheValleyOrCrossesIt) {
  // The best y for every x is x^2, and leaves (1 - x)^2 / 2; the optimum (1, 1) is beyond.
  for (const Vector& upper : {Vector{{0.5, 4}}, Vector{{3, 0.3}}}) {
    const Problem problem = half_rosenbrock(upper);
    const Eigen::Index bound = upper[0] == 0.5 ? 0 : 1;
    double lowest = infinity;
    for (int i = 0; i <= 20000; ++i) {
      Vector x = upper;
      x[1 - bound] = -2 + 5 * i / 20000.0;
      lowest = std::min(lowest, problem.evaluate(x).objective);
    }
    const Vector x = converged(problem, 3000);
    EXPECT_NEAR(x[bound], upper[bound], 1e-12);
    // Where a bound stops one of two coupled variables, Ceres stops short of the optimum.
    EXPECT_NEAR(problem.evaluate(x).objective, lowest, 0.01 * lowest);
  }
}

/// y = b0 (1 - exp(-b1 x)), from the farther of the two starts.
/// Source: Misra1a of the Statistical Reference Datasets of NIST,
/// https://www.itl.nist.gov/div898/strd/nls/data/misra1a.shtml.
Problem misra() {
  const Vector x{{77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1,
                  689.1, 760.0}};
  const Vector y{{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01,
                  66.40, 75.47, 81.78}};
  return least_squares(Vector{{100, 1e-5}}, Vector{{1000, 1e-2}}, Vector{{500, 1e-4}},
                       [x, y](const Vector& b) {
                         const Vector decay = (-b[1] * x).array().exp();
                         Matrix jacobian(x.size(), 2);
                         jacobian << 1 - decay.array(), b[0] * x.array() * decay.array();
                         return Residuals{b[0] * (1 - decay.array()) - y.array(), jacobian};
                       });
}

TEST(CeresLeastSquares, FitsAnExponentialToTheCertifiedDigits) {
  const Vector b = converged(misra(), 300);
  EXPECT_NEAR(b[0], 2.3894212918e+02, 1e-6 * 2.4e+02);
  EXPECT_NEAR(b[1], 5.5015643181e-04, 1e-6 * 5.5e-04);
  EXPECT_NEAR(2 * misra().evaluate(b).objective, 1.2455138894e-01, 1e-10);
}

TEST(CeresLeastSquares, PaysNoJacobianWhereItDoesNotStep) {
  Problem problem = half_rosenbrock();
  std::set<double> lowest;  // the objectives that were better than all before
  problem.residuals = [&, residuals = problem.residuals](const Vector& x) {
    const Residuals told = residuals(x);
    const double value = told.values.squaredNorm();
    if (lowest.empty() || value < *lowest.begin()) lowest.insert(value);
    return told;
  };
  const Ledger ledger = solved(problem, ceres_least_squares(), 1000).ledger;
  const auto steps = static_cast<std::int64_t>(lowest.size());
  EXPECT_GT(ledger.derivatives, steps) << "no step was refused";
  EXPECT_LE(ledger.charged, ledger.derivatives + 2 * steps);
}

TEST(CeresLeastSquares, StepsBackFromPointsWithoutNumbersButEndsAStartAtOne) {
  Problem problem = half_rosenbrock();  // its first step is to x = 0.78
  problem.residuals = [residuals = problem.residuals](const Vector& x) {
    return residuals(x[0] > 0.5 ? Vector::Constant(2, quiet_nan).eval() : x);
  };
  const Solved end = solved(problem, ceres_least_squares(), 300);
  EXPECT_LT(end.best->true_values.objective, 4);  // 12.1 at the start
  EXPECT_EQ(solved(never_a_number(2), ceres_least_squares(), 30).reason, "a number is not finite");
}

}  // namespace
}  // namespace ricochet
