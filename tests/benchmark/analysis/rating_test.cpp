#include "src/contest/rating.h"

#include <gtest/gtest.h>

#include "tests/contest/valley.h"

namespace ricochet::contest {
namespace {

TEST(Rating, TakesWholeLevelsForTheTargetsOfACount) {
  Question question = valley_question();
  question.tolerance = 0.5;
  EXPECT_EQ(targets_of(question), (std::vector<double>{0.5, 1.5, 2.5, 4.5, 8.5}));
  question.tolerance = 0.01;
  EXPECT_EQ(targets_of(question).size(), 4U);
  EXPECT_DOUBLE_EQ(targets_of(question).back(), 10);
}

TEST(Rating, PutsTheQuickBeforeTheSlowAndTheSlowBeforeTheHopeless) {
  ContestPlan plan;
  plan.questions = {valley_question()};
  plan.solvers = {patient("hopeless", 1000), patient("slow", 20), patient("quick", 3)};
  plan.instances = 6;
  plan.budgets = {50};
  auto standings = hold(plan);
  std::erase_if(standings, [](const Standing& s) { return s.form.width > 0; });
  const auto ratings = rate(plan, standings, {0}, 0);
  ASSERT_EQ(ratings.size(), 3U);
  EXPECT_EQ(ratings[0].solver, "quick");
  EXPECT_EQ(ratings[1].solver, "slow");
  EXPECT_EQ(ratings[2].solver, "hopeless");
  EXPECT_EQ(ratings[0].rank, 1);
  EXPECT_EQ(ratings[2].rank, 3);
  EXPECT_EQ(ratings[0].never, 0);
  EXPECT_EQ(ratings[2].never, 1);
  EXPECT_GT(ratings[0].probability_of_being_best, 0.8);
  EXPECT_LT(ratings[2].probability_of_being_best, 0.1);
  EXPECT_EQ(ratings[0].progress.front().share, 0);
  EXPECT_EQ(ratings[0].progress.back().share, 1);
  EXPECT_EQ(ratings[2].progress.back().share, 0);
}

TEST(Rating, GivesTwinsTheSameChance) {
  ContestPlan plan;
  plan.questions = {valley_question()};
  plan.solvers = {patient("a", 3), patient("b", 3)};
  plan.instances = 10;
  plan.budgets = {20};
  auto standings = hold(plan);
  std::erase_if(standings, [](const Standing& s) { return s.form.width > 0; });
  for (const Rating& rating : rate(plan, standings, {0}, 0)) {
    EXPECT_NEAR(rating.probability_of_being_best, 0.5, 0.05);
    EXPECT_EQ(rating.rank, 1.5);
  }
}

}  // namespace
}  // namespace ricochet::contest
