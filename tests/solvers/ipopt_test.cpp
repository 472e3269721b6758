#include "solvers/ipopt.h"

#include <gtest/gtest.h>

#include "src/core/run.h"
#include "tests/solvers/test_problems.h"

namespace ricochet {
namespace {

TEST(Ipopt, SolvesASphere) {
  const RunRecord record = run(sphere(4, 3), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.exits.front().reason, "solved");
  EXPECT_LT(record.trace.back().truth.objective, 1e-12);
}

TEST(Ipopt, ApproachesABoundFromInside) {
  const RunRecord record = run(sphere(2, 130), ipopt(Settings::tuned), {300}, 0);
  EXPECT_LT(record.trace.back().x.maxCoeff(), 100.0);
  EXPECT_NEAR(record.trace.back().truth.objective, 2 * 30 * 30, 1e-2);
}

TEST(Ipopt, EndsOnACurvedConstraintWithoutViolatingIt) {
  const RunRecord record = run(disc(), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.exits.front().reason, "solved");
  EXPECT_EQ(record.trace.back().truth.violation, 0.0);
  EXPECT_NEAR(record.trace.back().truth.objective, -std::sqrt(2.0), 1e-6);
}

TEST(Ipopt, KeepsAnEquationAndAnInequality) {
  const RunRecord record = run(arc(), ipopt(Settings::tuned), {300}, 0);
  EXPECT_EQ(record.exits.front().reason, "solved");
  EXPECT_EQ(record.trace.back().truth.violation, 0.0);
  EXPECT_NEAR(record.trace.back().truth.objective, *arc().best_known, 1e-6);
}

TEST(Ipopt, StopsAtWhateverCallTheEvaluatorRefuses) {
  for (std::int64_t budget = 0; budget < 60; ++budget) {
    const Problem problem = disc();
    Evaluator evaluator(problem, {budget});
    Random random;
    const SolverExit exit = ipopt(Settings::tuned).solve(evaluator, problem.start, random);
    if (!evaluator.over()) break;  // solved within the budget
    EXPECT_EQ(exit.reason, "stopped by the evaluator");
    EXPECT_LE(evaluator.ledger().charged, budget);
    EXPECT_GE(evaluator.ledger().charged, budget - 2) << "derivatives cost 2 more than values";
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

TEST(Ipopt, NeedsDerivatives) {
  EXPECT_TRUE(ipopt(Settings::tuned).accepts(disc()));
  Problem problem = disc();
  problem.differentiate = nullptr;
  EXPECT_FALSE(ipopt(Settings::tuned).accepts(problem));
}

}  // namespace
}  // namespace ricochet
