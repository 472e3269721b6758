#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "solvers/library_solvers.h"
#include "solvers/nlopt.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

Solver solver_named(const std::string& name) {
  for (Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::invalid_argument(name);
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
    const auto best_of = [&](const Solver& solver) {
      const RunRecord record = run(problem, solver, {400}, 0);
      return -record.trace.back().true_values.objective;
    };
    for (const char* name : {"nlopt-slsqp", "ipopt-tuned"}) {
      const Solver solver = solver_named(name);
      EXPECT_GT(std::abs(best_of(solver) - 8), 0.1) << name << " " << rise;
      EXPECT_NEAR(best_of(continuation(solver)), 8.0, 1e-3) << name << " " << rise;
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
  Evaluator evaluator(problem, {1000});
  Random random(1);
  continuation(solver_named("nlopt-slsqp")).solve(evaluator, problem.start, random);
  ASSERT_GT(smoothings.size(), 5U);
  EXPECT_EQ(smoothings.front(), 0.3);
  EXPECT_EQ(smoothings.back(), 0.0);
  EXPECT_TRUE(std::is_sorted(smoothings.rbegin(), smoothings.rend()));
}

// A budget may end between two smoothing parameters, before the next has shown a point.
TEST(Continuation, ReturnsItsBestPointWhereverTheBudgetEnds) {
  const Solver solver = continuation(solver_named("nlopt-slsqp"));
  for (const Problem& problem : {sphere(2, 3), disc()}) {
    int compared = 0;
    for (std::int64_t budget = 1; budget <= 200; ++budget) {
      const RunRecord record = run(problem, solver, {budget}, 0);
      if (record.trace.empty()) continue;
      ASSERT_TRUE(record.returned) << problem.name << ", " << budget;
      EXPECT_FALSE(better(record.trace.back().true_values, record.returned->true_values))
          << problem.name << ", " << budget;
      ++compared;
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(Continuation, AcceptsWhatHasTheKnobAndSuitsItsSolver) {
  const Solver solver = continuation(solver_named("nlopt-slsqp"));
  EXPECT_EQ(solver.name, "continuation-nlopt-slsqp");
  Problem problem = step_problem(3, 0.25);
  EXPECT_TRUE(solver.accepts(problem));
  problem.smoothed = nullptr;
  EXPECT_FALSE(solver.accepts(problem));
  EXPECT_FALSE(continuation(solver_named("nlopt-lbfgs")).accepts(step_problem(3, 0.25)));
}

}  // namespace
}  // namespace ricochet
