#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/outcomes.h"

namespace ricochet::comparison {
namespace {

Outcome returning(double gap, bool solved) {
  Outcome outcome;
  outcome.evaluations = 20;
  outcome.steps = {{2, 0, 9}, {5, 0, 4}, {8, 0, 0.1}};
  outcome.verdict.returned_optimality_gap = gap;
  outcome.verdict.returned_solved = solved;
  if (solved) outcome.verdict.evaluations_to_solve = 8;
  return outcome;
}

TEST(ReachedBy, IsTheGapAndWhenAPointAsGoodWasEvaluated) {
  const Reached reached = reached_by(returning(6, false));
  EXPECT_EQ(reached.value, 6);
  EXPECT_EQ(reached.cost, 5);
}

TEST(ReachedBy, DoesNotCountAccuracyBeyondTheTolerance) {
  const Reached reached = reached_by(returning(0.1, true));
  EXPECT_EQ(reached.value, 0);
  EXPECT_EQ(reached.cost, 8);
}

TEST(ReachedBy, IsInfiniteWithoutAFeasiblePoint) {
  Outcome outcome = returning(6, false);
  outcome.verdict.returned_optimality_gap.reset();
  EXPECT_TRUE(std::isinf(reached_by(outcome).value));
  EXPECT_TRUE(std::isinf(reached_by(outcome).cost));
}

}  // namespace
}  // namespace ricochet::comparison
