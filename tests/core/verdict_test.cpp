#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

RunRecord traced(std::vector<Improvement> trace) {
  RunRecord record;
  record.trace = std::move(trace);
  return record;
}

TEST(Verdict, FindsWhenTheTargetWasFirstReached) {
  const auto record = traced({{1, 0.1, {5, 0}, {}}, {4, 0.2, {0.5, 0}, {}}, {9, 0.3, {0, 0}, {}}});
  const Verdict verdict = judge(record, parabola(1), 1.0);
  EXPECT_TRUE(verdict.solved);
  EXPECT_EQ(verdict.evaluations_to_solve, 4);
  EXPECT_EQ(verdict.seconds_to_solve, 0.2);
  EXPECT_EQ(verdict.objective, 0.0);
  EXPECT_EQ(verdict.optimality_gap, 0.0);
}

TEST(Verdict, IgnoresPointsThatAreTrulyInfeasible) {
  const Verdict verdict = judge(traced({{1, 0.1, {-3, 0.5}, {}}}), parabola(1), 1.0);
  EXPECT_FALSE(verdict.feasible);
  EXPECT_FALSE(verdict.objective);
  EXPECT_FALSE(verdict.solved);
}

TEST(Verdict, HasNoOptimalityGapWithoutAKnownOptimum) {
  Problem problem = parabola(1);
  problem.best_known.reset();
  const Verdict verdict = judge(traced({{1, 0.1, {3, 0}, {}}}), problem, 1.0);
  EXPECT_EQ(verdict.objective, 3.0);
  EXPECT_FALSE(verdict.optimality_gap);
  EXPECT_FALSE(verdict.solved);
}

}  // namespace
}  // namespace ricochet
