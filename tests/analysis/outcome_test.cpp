#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/outcomes.h"
#include "tests/analysis/valley.h"

namespace ricochet::comparison {
namespace {

TEST(Outcome, KeepsFeasibleImprovementsExitsAndWhatWasThrown) {
  RunRecord record;
  record.instance = 3;
  record.ledger.charged = 20;
  record.trace = {{1, 0.1, {0.25, 1.0}, {}}, {4, 0.2, {0.5, 0}, {}}, {9, 0.3, {0, 0}, {}}};
  record.terminations = {{"lost"}, {"done"}};
  record.failure = "broken";
  const Outcome outcome = outcome_of(record, valley(0), 0.1);
  EXPECT_EQ(outcome.instance, 3);
  EXPECT_EQ(outcome.evaluations, 20);
  ASSERT_EQ(outcome.steps.size(), 2U) << "the first point was not feasible";
  EXPECT_EQ(outcome.steps[0].evaluations, 4);
  EXPECT_EQ(outcome.steps[0].optimality_gap, 0.5);
  EXPECT_EQ(outcome.terminations, (std::vector<Reason>{"lost", "done"}));
  EXPECT_EQ(outcome.failure, "broken");
  EXPECT_EQ(outcome.verdict.evaluations_to_solve, 9);
}

/// A run of 20 evaluations whose gaps fall to 1.
Outcome falling() {
  Outcome outcome;
  outcome.evaluations = 20;
  outcome.seconds = 2;
  outcome.steps = {{2, 0.2, 9}, {5, 0.5, 4}, {8, 0.8, 1}};
  outcome.verdict.optimality_gap = 1;
  return outcome;
}

TEST(Outcome, HasTheStepsThatLedToTheReturnedPoint) {
  Outcome outcome = falling();
  EXPECT_TRUE(steps_of(outcome).empty()) << "it returned nothing";
  EXPECT_TRUE(std::isinf(outcome.optimality_gap()));
  outcome.verdict.returned_optimality_gap = 6;
  auto steps = steps_of(outcome);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].evaluations, 5) << "the first point that is as good";
  EXPECT_EQ(steps[1].optimality_gap, 6);
  outcome.verdict.returned_optimality_gap = 0.5;
  steps = steps_of(outcome);
  ASSERT_EQ(steps.size(), 4U) << "better than all that it evaluated";
  EXPECT_EQ(steps[3].evaluations, 20);
}

TEST(Outcome, IsSolvedByWhatItReturned) {
  Outcome outcome = falling();
  outcome.verdict.solved = true;
  outcome.verdict.evaluations_to_solve = 8;
  outcome.verdict.seconds_to_solve = 0.8;
  EXPECT_FALSE(outcome.solved());
  EXPECT_EQ(evaluations_until_solved(outcome), 20);
  EXPECT_EQ(seconds_until_solved(outcome), 2);
  EXPECT_EQ(evaluations_until_solved(outcome, Criterion::evaluated), 8);
  outcome.verdict.returned_solved = true;
  EXPECT_TRUE(outcome.solved());
  EXPECT_EQ(evaluations_until_solved(outcome), 8);
  EXPECT_EQ(seconds_until_solved(outcome), 0.8);
}

}  // namespace
}  // namespace ricochet::comparison
