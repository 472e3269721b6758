#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// A problem of two variables that is half the sum of the squares of `residuals`.
template <class Function>
Problem least_squares(Vector lower, Vector upper, Vector start, Function residuals) {
  Problem problem;
  problem.name = "least-squares";
  problem.source = "the solvers' tests";
  problem.lower = std::move(lower);
  problem.upper = std::move(upper);
  problem.start = std::move(start);
  problem.residuals = residuals;
  problem.evaluate = [residuals](const Vector& x) {
    return Values{residuals(x).values.squaredNorm() / 2, {}};
  };
  return problem;
}

/// Half of Rosenbrock's function, Computer Journal 3 (1960) 175-184, from his start; `unit` is that
/// of the residuals. Without bounds the optimum is 0 at (1, 1).
Problem rosenbrock(const Vector& lower, const Vector& upper, double unit = 1) {
  return least_squares(lower, upper, Vector{{-1.2, 1.0}}.cwiseMin(upper), [unit](const Vector& x) {
    return Residuals{unit * Vector{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}},
                     unit * Matrix{{-20 * x[0], 10.0}, {-1.0, 0.0}}};
  });
}

Vector solved(const Problem& problem, std::int64_t budget) {
  Scorer scorer(problem);
  Evaluator evaluator(problem, {budget}, &scorer);
  Random random;
  EXPECT_EQ(ceres_least_squares().solve(evaluator, problem.start, random).reason, "converged");
  return scorer.best()->x;
}

TEST(CeresLeastSquares, FollowsACurvedValleyToAnOptimumInside) {
  const Vector x = solved(rosenbrock(Vector{{-2, -2}}, Vector{{3, 4}}), 300);
  EXPECT_LT((x - Vector{{1, 1}}).norm(), 1e-9);
}

TEST(CeresLeastSquares, GoesStraightToAnOptimumInACorner) {
  const Problem problem = sphere(2, 130);
  Scorer scorer(problem);
  Evaluator evaluator(problem, {300}, &scorer);
  Random random;
  EXPECT_EQ(ceres_least_squares().solve(evaluator, problem.start, random).reason, "converged");
  EXPECT_EQ(scorer.best()->x, problem.upper);
  EXPECT_EQ(evaluator.ledger().derivatives, 3) << "it knows the bounds, but asks twice at the end";
}

// Where a bound stops one of two coupled variables, Ceres stops short of the optimum.
constexpr double excess_on_a_bound = 0.01;

TEST(CeresLeastSquares, EndsOnTheBoundWhereTheValleyDoes) {
  // The best y for every x is x^2, and leaves (1 - x)^2 / 2: the lower, the larger x.
  const Problem problem = rosenbrock(Vector{{-2, -2}}, Vector{{0.5, 4}});
  const Vector x = solved(problem, 3000);
  EXPECT_NEAR(x[0], 0.5, 1e-12);
  EXPECT_NEAR(problem.evaluate(x).objective, 0.125, excess_on_a_bound * 0.125);
}

TEST(CeresLeastSquares, FindsTheBestOfABoundThatCrossesTheValley) {
  const Problem problem = rosenbrock(Vector{{-2, -2}}, Vector{{3, 0.3}});
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 20000; ++i) {
    const Vector x{{-2 + 5 * i / 20000.0, 0.3}};  // the optimum (1, 1) is beyond this bound
    lowest = std::min(lowest, problem.evaluate(x).objective);
  }
  const Vector x = solved(problem, 3000);
  EXPECT_NEAR(x[1], 0.3, 1e-12);
  EXPECT_NEAR(problem.evaluate(x).objective, lowest, excess_on_a_bound * lowest);
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
  const Problem problem = misra();
  const Vector b = solved(problem, 300);
  EXPECT_NEAR(b[0], 2.3894212918e+02, 1e-6 * 2.4e+02);
  EXPECT_NEAR(b[1], 5.5015643181e-04, 1e-6 * 5.5e-04);
  EXPECT_NEAR(2 * problem.evaluate(b).objective, 1.2455138894e-01, 1e-10);
}

TEST(CeresLeastSquares, ConvergesWhateverTheUnitOfTheResiduals) {
  for (const double unit : {1e-6, 1e6}) {
    const Vector x = solved(rosenbrock(Vector{{-2, -2}}, Vector{{3, 4}}, unit), 1000);
    EXPECT_LT((x - Vector{{1, 1}}).norm(), 1e-6) << unit;
  }
}

TEST(CeresLeastSquares, StopsAtWhateverCallTheEvaluatorRefuses) {
  for (std::int64_t budget = 0; budget < 60; ++budget) {
    const Problem problem = rosenbrock(Vector{{-2, -2}}, Vector{{3, 4}});
    Evaluator evaluator(problem, {budget});
    Random random;
    EXPECT_EQ(ceres_least_squares().solve(evaluator, problem.start, random).reason,
              "stopped by the evaluator");
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
    EXPECT_LE(evaluator.ledger().charged, budget);
    EXPECT_GE(evaluator.ledger().charged, budget - 1) << "a Jacobian, 2, may not fit any more";
  }
}

TEST(CeresLeastSquares, PaysNoJacobianWhereItDoesNotStep) {
  Problem problem = rosenbrock(Vector{{-2, -2}}, Vector{{3, 4}});
  std::set<double> lowest;  // the objectives that were better than all before
  double best = std::numeric_limits<double>::infinity();
  problem.residuals = [&, residuals = problem.residuals](const Vector& x) {
    const Residuals told = residuals(x);
    const double value = told.values.squaredNorm();
    if (value < best) lowest.insert(best = value);
    return told;
  };
  Evaluator evaluator(problem, {1000});
  Random random;
  ceres_least_squares().solve(evaluator, problem.start, random);
  const auto steps = static_cast<std::int64_t>(lowest.size());
  EXPECT_GT(evaluator.ledger().derivatives, steps) << "no step was refused";
  EXPECT_LE(evaluator.ledger().charged, evaluator.ledger().derivatives + 2 * steps);
}

TEST(CeresLeastSquares, EndsAStartWithoutNumbers) {
  EXPECT_EQ(run(never_a_number(2), ceres_least_squares(), {30}, 0).terminations.front().reason,
            "a number is not finite");
}

/// Rosenbrock's function without numbers where x is above 0.5; 0.125 at (0.5, 0.25) is the best
/// left.
Problem half_rosenbrock() {
  Problem problem = rosenbrock(Vector{{-2, -2}}, Vector{{3, 4}});
  problem.residuals = [residuals = problem.residuals](const Vector& x) {
    return residuals(x[0] > 0.5 ? Vector::Constant(2, not_a_number).eval() : x);
  };
  return problem;
}

TEST(CeresLeastSquares, StepsBackFromPointsWithoutNumbers) {
  const Problem problem = half_rosenbrock();  // its first step is to x = 0.78
  Scorer scorer(problem);
  Evaluator evaluator(problem, {300}, &scorer);
  Random random;
  ceres_least_squares().solve(evaluator, problem.start, random);
  EXPECT_LT(scorer.best()->true_values.objective, 4);  // 12.1 at the start
}

TEST(CeresLeastSquares, SaysNothingEvenWhenItFails) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run(never_a_number(2), ceres_least_squares(), {30}, 0);
  run(half_rosenbrock(), ceres_least_squares(), {300}, 0);
  run(breaks_after(4, 2), ceres_least_squares(), {300}, 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CeresLeastSquares, TakesOnlyWhatItCanDo) {
  EXPECT_TRUE(ceres_least_squares().accepts(sphere(2, 3)));
  Problem constrained = disc();
  constrained.residuals = sphere(2, 3).residuals;
  EXPECT_FALSE(ceres_least_squares().accepts(constrained));
  EXPECT_FALSE(ceres_least_squares().accepts(staircase()));
}

}  // namespace
}  // namespace ricochet
