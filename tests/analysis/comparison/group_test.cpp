#include "src/analysis/comparison/group.h"

#include <gtest/gtest.h>

#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A run of 100 evaluations that evaluated a solving point after 10, or none, and returned it or
/// not.
Outcome run_of(bool evaluated, bool returned) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.solved = evaluated;
  outcome.verdict.returned_solved = returned;
  if (evaluated) outcome.verdict.evaluations_to_solve = 10;
  outcome.verdict.optimality_gap = evaluated ? 0.0 : 1.0;
  outcome.verdict.returned_optimality_gap = returned ? 0.0 : 1.0;
  outcome.steps = {{10, 0.1, *outcome.verdict.optimality_gap}};
  return outcome;
}

/// The data of one family, on which chance-a and chance-b have these runs.
Json group_of(const std::string& problems, const Outcome& a, const Outcome& b) {
  const Campaign campaign(plan_from("[[part]]\nproblems = [" + problems +
                                        "]\nsolvers = \"chance-*\"\nbudgets = 100\ninstances = 1\n",
                                    "test"),
                          made_up_catalogue());
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    return std::vector{cell.cell.solver == "chance-a" ? a : b};
  });
  const Comparison comparison = comparison_of(campaign, results, {});
  const auto groups = groups_of(comparison);
  return group_data(comparison, groups, ratings_of(comparison, groups)).at(0);
}

const std::string two = "\"bowl-1\", \"bowl-2\"";

TEST(Groups, SayInTheSameRowThatAnotherIsFirstByTheBestEvaluatedPoint) {
  Outcome late = run_of(true, true);
  late.verdict.evaluations_to_solve = 50;
  const Json leader = group_of(two, run_of(true, false), late)["budgets"][0]["leader"];
  EXPECT_EQ(leader["solver"], "chance-b");
  EXPECT_EQ(leader["returned"], 1);
  EXPECT_EQ(leader["best"], 1);
  EXPECT_EQ(leader["of"], 2);
  EXPECT_EQ(leader["single"], false);
  EXPECT_EQ(leader["differs"], true);
  EXPECT_EQ(leader["by_evaluated"]["entry"], "chance-a, original");
  EXPECT_EQ(leader["by_evaluated"]["found"], 1);
  EXPECT_EQ(leader["by_evaluated"]["returned"], 0);
  EXPECT_EQ(leader["by_evaluated"]["surrogate"], false);
}

TEST(Groups, HaveTheCurvesOfTheFirstWithTheEndsAloneOfLevelParts) {
  const Json budget = group_of(two, run_of(true, true), run_of(false, false))["budgets"][0];
  ASSERT_EQ(budget["first"].size(), 2U);
  EXPECT_TRUE(budget["paper"].empty());
  EXPECT_TRUE(budget["rest"].empty());
  const Json& progress = budget["first"][0]["progress"];
  EXPECT_EQ(budget["first"][0]["solver"], "chance-a");
  EXPECT_EQ(progress.back()["share"], 1);
  for (std::size_t i = 2; i < progress.size(); ++i) {
    EXPECT_FALSE(progress[i]["share"] == progress[i - 1]["share"] &&
                 progress[i]["share"] == progress[i - 2]["share"]);
  }
}

TEST(Groups, NameNobodyFirstWhereNobodySolvedARun) {
  const Json leader =
      group_of(two, run_of(true, false), run_of(false, false))["budgets"][0]["leader"];
  EXPECT_TRUE(leader["solver"].is_null());
  EXPECT_TRUE(leader["best"].is_null());
  EXPECT_EQ(leader["by_evaluated"]["entry"], "chance-a, original");
  const Json none =
      group_of(two, run_of(false, false), run_of(false, false))["budgets"][0]["leader"];
  EXPECT_TRUE(none["solver"].is_null());
  EXPECT_TRUE(none["by_evaluated"].is_null());
  EXPECT_EQ(none["differs"], false);
}

TEST(Groups, HaveNoProbabilityOnOneProblem) {
  const Json group = group_of("\"bowl-1\"", run_of(true, true), run_of(false, false));
  const Json& leader = group["budgets"][0]["leader"];
  EXPECT_EQ(leader["solver"], "chance-a");
  EXPECT_EQ(leader["single"], true);
  EXPECT_TRUE(leader["best"].is_null());
  EXPECT_TRUE(leader["by_evaluated"].is_null());
  EXPECT_EQ(leader["differs"], false);
  EXPECT_EQ(group["problems"][0]["targets"], 51);
  EXPECT_EQ(group["shares"][0]["shares"][0], 1);
}

}  // namespace
}  // namespace ricochet::studies::comparison
