#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(Ipopt, SolvesASphere) {
  const RunRecord record = run(sphere(4, 3), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.terminations.front().reason, "solved");
  EXPECT_LT(record.trace.back().true_values.objective, 1e-12);
}

TEST(Ipopt, ApproachesABoundFromInside) {
  const RunRecord record = run(sphere(2, 130), ipopt(Settings::tuned), {300}, 0);
  EXPECT_LT(record.trace.back().x.maxCoeff(), 100.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, 2 * 30 * 30, 1e-2);
}

TEST(Ipopt, EndsOnACurvedConstraintWithoutViolatingIt) {
  const RunRecord record = run(disc(), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.terminations.front().reason, "solved");
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -std::sqrt(2.0), 1e-6);
}

TEST(Ipopt, KeepsAnEquationAndAnInequality) {
  const RunRecord record = run(arc(), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.terminations.front().reason, "solved");
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, *arc().best_known, 1e-6);
}

TEST(Ipopt, StopsAtWhateverCallTheEvaluatorRefuses) {
  for (std::int64_t budget = 0; budget < 60; ++budget) {
    const Problem problem = disc();
    Evaluator evaluator(problem, {budget});
    Random random;
    const SolverTermination exit = ipopt(Settings::tuned).solve(evaluator, problem.start, random);
    if (!evaluator.over()) break;  // solved within the budget
    EXPECT_EQ(exit.reason, "stopped by the evaluator");
    EXPECT_LE(evaluator.ledger().charged, budget);
    EXPECT_GE(evaluator.ledger().charged, budget - 2) << "derivatives cost 2 more than values";
  }
}

/// disc(), whose constraint has a slope that is infinite and one that is NaN wherever it is asked.
Problem broken_disc() {
  Problem problem = disc();
  problem.differentiate = [differentiate = problem.differentiate](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.jacobian << HUGE_VAL, not_a_number;
    return derivatives;
  };
  return problem;
}

// In the process's memory MUMPS finds by chance what it crashes at: several starts find it, too.
TEST(Ipopt, EndsWhereASlopeOfAConstraintIsNotFinite) {
  const RunRecord record = run(broken_disc(), ipopt(Settings::tuned), {300}, 0);
  ASSERT_GT(record.terminations.size(), 2U);
  for (const SolverTermination& exit : record.terminations) {
    if (&exit == &record.terminations.back()) break;  // stopped by the evaluator
    EXPECT_EQ(exit.reason, "a number is not finite");
  }
}

TEST(Ipopt, SaysNothingEvenWhenItFails) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run(never_a_number(2), ipopt(Settings::tuned), {30}, 0);
  run(half_a_number(), ipopt(Settings::tuned), {100}, 0);
  run(breaks_after(4, 2), ipopt(Settings::tuned), {100}, 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// Sum of 10^(6 i / 9) (x_i - 1)^2, i from 0 to 9, on [-10, 10]^10 from 4: optimum 0 at x_i = 1.
/// With second derivatives.
Problem ellipsoid() {
  Vector weights(10);
  for (Eigen::Index i = 0; i < 10; ++i) weights[i] = std::pow(10, 6 * static_cast<double>(i) / 9);
  Problem problem = box_problem("ellipsoid", 10, -10, 10, 4, [weights](const Vector& x) {
    return weights.dot((x.array() - 1).square().matrix());
  });
  differentiate_by(problem, [weights](const Vector& x) -> Vector {
    return 2 * weights.array() * (x.array() - 1);
  });
  curve_by(problem, [weights](const Vector&) -> Matrix { return (2 * weights).asDiagonal(); });
  return problem;
}

/// What a solve asked for; it must be solved, and find a point below `good`.
Ledger ledger_of(const Problem& problem, const Solver& solver, double good) {
  Scorer scorer(problem);
  Evaluator evaluator(problem, {20'000}, &scorer);
  Random random;
  EXPECT_EQ(solver.solve(evaluator, problem.start, random).reason, "solved") << solver.name;
  EXPECT_LT(scorer.best()->true_values.objective, good) << solver.name;
  return evaluator.ledger();
}

TEST(IpoptExact, TakesFewerStepsThanWithALimitedMemory) {
  const Ledger exact = ledger_of(sphere(4, 3), ipopt_exact(), 1e-12);
  const Ledger limited = ledger_of(sphere(4, 3), ipopt(Settings::own), 1e-12);
  EXPECT_LT(exact.derivatives, limited.derivatives);
  EXPECT_GT(exact.hessians, 0);
  EXPECT_EQ(limited.hessians, 0);
}

TEST(IpoptExact, DoesNotMindHowUnlikeTheScalesOfAQuadraticAre) {
  const Ledger ledger = ledger_of(ellipsoid(), ipopt_exact(), 1e-10);
  EXPECT_LT(ledger.derivatives, 20);
}

TEST(IpoptExact, KeepsAnEquationAndAnInequality) {
  const RunRecord record = run(arc(), ipopt_exact(), {300}, 0);
  EXPECT_EQ(record.terminations.front().reason, "solved");
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_NEAR(record.trace.back().true_values.objective, *arc().best_known, 1e-6);
}

TEST(IpoptExact, NeedsSecondDerivatives) {
  EXPECT_TRUE(ipopt_exact().accepts(disc()));
  Problem problem = disc();
  problem.lagrangian_hessian = nullptr;
  EXPECT_FALSE(ipopt_exact().accepts(problem));
}

TEST(Ipopt, NeedsDerivatives) {
  EXPECT_TRUE(ipopt(Settings::tuned).accepts(disc()));
  Problem problem = disc();
  problem.differentiate = nullptr;
  EXPECT_FALSE(ipopt(Settings::tuned).accepts(problem));
}

}  // namespace
}  // namespace ricochet
