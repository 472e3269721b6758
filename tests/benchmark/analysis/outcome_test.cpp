#include "src/benchmark/analysis/outcome.h"

#include <gtest/gtest.h>

#include "tests/benchmark/analysis/valley.h"

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

}  // namespace
}  // namespace ricochet::comparison
