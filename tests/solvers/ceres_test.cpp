#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(CeresLbfgs, BeginsAtTheStart) {
  const Problem problem = sphere(2, 3);
  const RunRecord record = run(problem, ceres_lbfgs(), {3}, 0);
  EXPECT_LT((record.trace.front().x - problem.start).norm(), 1e-12);
}

TEST(CeresLbfgs, LeavesAStartOnTheBound) {
  Problem problem = sphere(3, 3);
  problem.start = Vector{{100, -100, 100}};
  Scorer scorer(problem);
  Evaluator evaluator(problem, {1000}, &scorer);
  Random random;
  EXPECT_EQ(ceres_lbfgs().solve(evaluator, problem.start, random).reason, "converged");
  EXPECT_LT(scorer.best()->true_values.objective, 1e-12);
}

TEST(CeresLbfgs, DoesNotTakeAStartWithoutANumberForAnOptimum) {
  EXPECT_EQ(run(never_a_number(2), ceres_lbfgs(), {30}, 0).terminations.front().reason, "failure");
}

TEST(CeresLbfgs, FindsAnOptimumOnTheBound) {
  const RunRecord record = run(sphere(2, 130), ceres_lbfgs(), {300}, 0);
  EXPECT_NEAR(record.trace.back().true_values.objective, 2 * 30 * 30, 1e-6);
}

TEST(CeresLbfgs, SaysNothingEvenWhenItFails) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run(never_a_number(2), ceres_lbfgs(), {30}, 0);
  run(half_a_number(), ceres_lbfgs(), {300}, 0);
  run(breaks_after(4, 2), ceres_lbfgs(), {300}, 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CeresLbfgs, TakesOnlyWhatItCanDo) {
  EXPECT_TRUE(ceres_lbfgs().accepts(sphere(2, 3)));
  EXPECT_FALSE(ceres_lbfgs().accepts(disc()));
  Problem problem = sphere(2, 3);
  problem.differentiate = nullptr;
  EXPECT_FALSE(ceres_lbfgs().accepts(problem));
}

}  // namespace
}  // namespace ricochet
