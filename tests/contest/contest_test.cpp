#include "src/contest/contest.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/contest/valley.h"

namespace ricochet::contest {
namespace {

ContestPlan patient_plan() {
  ContestPlan plan;
  plan.questions = {valley_question()};
  plan.solvers = {patient("quick", 3), patient("slow", 30), patient("steep", 5, true)};
  plan.instances = 4;
  plan.budgets = {10, 40};
  return plan;
}

TEST(Contest, PutsEverySolverToEveryFormThatItAccepts) {
  const ContestPlan plan = patient_plan();
  const auto standings = hold(plan);
  ASSERT_EQ(standings.size(), 2U * (2 + 2 + 1)) << "two budgets, two forms but for the last";
  EXPECT_EQ(plan.questions[0].name_of(standings[0].form), "count");
  EXPECT_EQ(plan.questions[0].name_of(standings[2].form), "surrogate");
  EXPECT_EQ(standings.back().solver, "steep");
  EXPECT_EQ(plan.questions[0].name_of(standings.back().form), "surrogate");
}

TEST(Contest, CountsEveryRunWithWhatItSpentUntilItSolved) {
  const auto standings = hold(patient_plan());
  const Standing& quick = standings[0];
  ASSERT_EQ(quick.outcomes.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Outcome& o = quick.outcomes[i];
    EXPECT_EQ(o.instance, static_cast<int>(i) + 1);
    EXPECT_EQ(o.verdict.evaluations_to_solve, 4);
    EXPECT_FALSE(o.verdict.handed_over_solved) << "it hands over the end of the box";
    EXPECT_EQ(o.evaluations, 10);
  }
  for (const Outcome& o : standings[4].outcomes) EXPECT_FALSE(o.verdict.solved) << "slow, of 10";
  for (const Outcome& o : standings[5].outcomes) EXPECT_TRUE(o.verdict.solved) << "slow, of 40";
}

TEST(Contest, IsTheSameOnOneThread) {
  const auto two = hold(patient_plan());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = hold(patient_plan());
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    for (std::size_t i = 0; i < one[k].outcomes.size(); ++i) {
      EXPECT_EQ(one[k].outcomes[i].verdict.regret, two[k].outcomes[i].verdict.regret);
      EXPECT_EQ(one[k].outcomes[i].steps.size(), two[k].outcomes[i].steps.size());
    }
  }
}

TEST(Contest, RefusesAQuestionWhoseBestValueIsNotKnown) {
  ContestPlan plan = patient_plan();
  plan.questions[0].stated.best_known.reset();
  EXPECT_THROW(hold(plan), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::contest
