// Random search, scan, bisection, golden section, and continuation.

#include "solvers/library_solvers.h"
#include "src/core/instance.h"
#include "tests/solvers/solve.h"
#include "tests/support/test.h"

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
  EXPECT_THAT(mirrored,
              testing::ElementsAre(0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875, 0.0625));
  const Problem problem = box_problem("even", 1, 2, 18, 9, [](const Vector&) { return 0.0; });
  std::vector<double> asked, grid;
  for (const Vector& x : asked_points(problem, scan(), 17, 0)) asked.push_back(x[0]);
  for (int k = 2; k <= 18; ++k) grid.push_back(k);
  EXPECT_THAT(asked, testing::UnorderedElementsAreArray(grid));
}

TEST(Bisection, HalvesTheIntervalThatHoldsTheLimit) {
  // Both ends, then the start, then 18 / 2^k.
  const TrueValues best = best_of(run(limited(7), bisection(), {2 + 1 + 12}, 0));
  EXPECT_NEAR(best.objective, -7, 18 / 4096.0);
  EXPECT_LE(best.violation, 0);
}

TEST(Bisection, HandsOverAFeasiblePointAtTheLimit) {
  const RunRecord record = run(limited(7), bisection(), {40}, 0);
  ASSERT_TRUE(record.returned);
  EXPECT_NEAR(record.returned->x[0], 7, 1e-6);
  EXPECT_LE(record.returned->true_values.violation, 0);
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
  problem.best_known = rise > 2.5 ? -8.0 : -18.0;
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

// A budget may end between two smoothing parameters, before the next has shown a point.
TEST(Continuation, ReturnsItsBestPointWhereverTheBudgetEnds) {
  for (const Problem& problem : {sphere(2, 3), disc()}) {
    int compared = 0;
    for (std::int64_t budget = 1; budget <= 200; ++budget) {
      const RunRecord record = run(problem, continuation(solver_named("nlopt-slsqp")), {budget}, 0);
      if (record.trace.empty()) continue;
      ASSERT_TRUE(record.returned) << problem.name << ", " << budget;
      EXPECT_FALSE(better(best_of(record), record.returned->true_values))
          << problem.name << ", " << budget;
      ++compared;
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(Continuation, TakesWhatItsSolverTakesIfThatCanBeSmoothed) {
  const Solver solver = continuation(solver_named("nlopt-slsqp"));
  EXPECT_EQ(solver.name, "continuation-nlopt-slsqp");
  EXPECT_TRUE(solver.capabilities.needs_smoothing);
  EXPECT_TRUE(solver.accepts(step_problem(3, 0.25)));
  EXPECT_FALSE(continuation(solver_named("nlopt-lbfgs")).accepts(step_problem(3, 0.25)));
}

}  // namespace
}  // namespace ricochet
