// What every solver that takes constraints promises about them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// What a count exceeds its limit by, on [0, 18]^n from 13: 0 where no coordinate is 2 or more
/// from 7, more elsewhere, nowhere less. The objective falls towards the pocket's upper corner, and
/// beyond. With slopes that show the way, as a surrogate has.
Problem pocket(Eigen::Index n) {
  Problem problem = box_problem("pocket", n, 0, 18, 13, [](const Vector& x) { return -x.sum(); });
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    const double away = (x.array() - 7).abs().maxCoeff();
    return Values{-x.sum(), Vector::Constant(1, std::floor(away / 2))};
  };
  problem.differentiate = [n, evaluate = problem.evaluate](const Vector& x) {
    Eigen::Index farthest = 0;
    (x.array() - 7).abs().maxCoeff(&farthest);
    const double side = x[farthest] > 7 ? 0.5 : -0.5;
    return Derivatives{evaluate(x), -Vector::Ones(n), side * Vector::Unit(n, farthest).transpose()};
  };
  problem.lagrangian_hessian = [n](const Vector&, double, const Vector&) -> Matrix {
    return Matrix::Zero(n, n);
  };
  return with_idle_knob(problem);
}

/// The smallest of these that the solver accepts.
Problem accepted_pocket(const Solver& solver) {
  return solver.accepts(pocket(1)) ? pocket(1) : pocket(2);
}

/// `problem` with its constraints, which are of size 1, in another unit.
Problem with_constraints_times(double factor, const Problem& problem) {
  Problem scaled = problem;
  scaled.evaluate = [factor, evaluate = problem.evaluate](const Vector& x) {
    Values values = evaluate(x);
    values.constraints *= factor;
    return values;
  };
  scaled.differentiate = [factor, differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.values.constraints *= factor;
    derivatives.jacobian *= factor;
    return derivatives;
  };
  scaled.lagrangian_hessian = [factor, hessian = problem.lagrangian_hessian](
                                  const Vector& x, double objective_factor,
                                  const Vector& multipliers) {
    return hessian(x, objective_factor, factor * multipliers);
  };
  return with_idle_knob(scaled);
}

std::vector<Solver> constrained_solvers() {
  std::vector<Solver> solvers;
  for (Solver& solver : all_solvers()) {
    if (solver.accepts(accepted_pocket(solver))) solvers.push_back(std::move(solver));
  }
  return solvers;
}

class ConstraintContract : public testing::TestWithParam<Solver> {
 protected:
  const Solver& solver() const { return GetParam(); }
};

// A margin in what a solver is shown would leave it no feasible point at all.
TEST_P(ConstraintContract, ReturnsAPointAtItsLimit) {
  const Problem problem = accepted_pocket(solver());
  const RunRecord record = run(problem, solver(), {2000}, 0);
  EXPECT_EQ(record.failure, "");
  ASSERT_TRUE(record.returned);
  EXPECT_EQ(problem.evaluate(record.returned->x).constraints[0], 0);
  EXPECT_EQ(record.returned->true_values.violation, 0);
}

/// Returns true for a reason in which a solver says that it has converged.
bool claims_success(const std::string& reason) {
  const std::vector<std::string> claims = {"solved",       "solved to an acceptable level",
                                           "xtol reached", "ftol reached",
                                           "success",      "converged"};
  return std::find(claims.begin(), claims.end(), reason) != claims.end();
}

TEST_P(ConstraintContract, ReturnsFeasiblePointsWhereItSaysThatItHasConverged) {
  // COBYLA says "xtol reached" at a short step, whatever the violation; this step is 1e-4 of the
  // box.
  if (solver().name == "nlopt-cobyla-tuned") GTEST_SKIP() << "it claims nothing of constraints";
  for (const double factor : {1.0, 100.0, 0.01}) {
    for (const Problem& stated : {disc(), arc()}) {
      const Problem problem = with_constraints_times(factor, stated);
      if (!solver().accepts(problem)) continue;
      // DIRECT keeps all its boxes: its time grows with the square of the evaluations.
      const bool divides = solver().name.starts_with("nlopt-direct");
      Evaluator evaluator(problem, {divides ? 1000 : 5000});
      Random random(1);
      const SolverTermination exit = solver().solve(evaluator, problem.start, random);
      if (!claims_success(exit.reason) || !exit.point) continue;
      EXPECT_EQ(true_values_at(problem, *exit.point).violation, 0)
          << stated.name << " with constraints times " << factor << ", " << exit.reason;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ConstraintContract, testing::ValuesIn(constrained_solvers()),
                         [](const auto& tested) { return test_name(tested.param.name); });

}  // namespace
}  // namespace ricochet
