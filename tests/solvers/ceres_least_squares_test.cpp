#include "solvers/library_solvers.h"
#include "tests/solvers/solve.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

/// A problem of two variables that is half the sum of the squares of `residuals`.
template <class Function>
Problem least_squares(const Vector& lower, const Vector& upper, const Vector& start,
                      Function residuals) {
  Problem problem = box_problem("least-squares", 2, 0, 0, 0, [residuals](const Vector& x) {
    return residuals(x).values.squaredNorm() / 2;
  });
  problem.lower = lower;
  problem.upper = upper;
  problem.start = start;
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
  EXPECT_LT((converged(half_rosenbrock(), 300) - Vector{{1, 1}}).norm(), 1e-9);
  for (const double unit : {1e-6, 1e6}) {
    const Vector x = converged(half_rosenbrock(Vector{{3, 4}}, unit), 1000);
    EXPECT_LT((x - Vector{{1, 1}}).norm(), 1e-6) << unit;
  }
}

TEST(CeresLeastSquares, GoesStraightToAnOptimumInACorner) {
  const Problem problem = sphere(2, 130);
  const Solved end = solved(problem, ceres_least_squares(), 300);
  EXPECT_EQ(end.reason, "converged");
  EXPECT_EQ(end.best->x, problem.upper);
  EXPECT_EQ(end.ledger.derivatives, 3) << "it knows the bounds, but asks twice at the end";
}

// Where a bound stops one of two coupled variables, Ceres stops short of the optimum.
constexpr double excess_on_a_bound = 0.01;

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
    EXPECT_NEAR(problem.evaluate(x).objective, lowest, excess_on_a_bound * lowest);
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

TEST(CeresLeastSquares, StopsAtWhateverCallTheEvaluatorRefuses) {
  for (std::int64_t budget = 0; budget < 60; ++budget) {
    const Solved end = solved(half_rosenbrock(), ceres_least_squares(), budget);
    EXPECT_EQ(end.reason, "stopped by the evaluator");
    EXPECT_EQ(end.ended, TerminationReason::evaluations);
    EXPECT_LE(end.ledger.charged, budget);
    EXPECT_GE(end.ledger.charged, budget - 1) << "a Jacobian, 2, may not fit any more";
  }
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
