#include <gtest/gtest.h>

#include "src/analysis/comparison/pairs.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

Outcome ended_after(std::optional<std::int64_t> solved) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.solved = outcome.verdict.returned_solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  return outcome;
}

// Of the first problem A needs 10 evaluations and B 40, of the second only B solves it.
TEST(LogRatio, SetsTheBestTwoAgainstEachOther) {
  const Campaign campaign(
      plan_from("name = \"t\"\n[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = "
                "[\"chance-*\"]\nbudgets = [100]\ninstances = 1\n",
                "test"),
      made_up_catalogue());
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const bool first = cell.cell.problem == "bowl-1";
    const bool is_a = cell.cell.solver == "chance-a";
    return std::vector{first ? ended_after(is_a ? 10 : 40)
                             : ended_after(is_a ? std::nullopt : std::optional<std::int64_t>(40))};
  });
  const Json data =
      log_ratio_data(campaign, entry_sets_of(campaign, results, reported_parts(campaign)));
  ASSERT_EQ(data.size(), 1);
  // PAR10 puts B first: it always solves.
  EXPECT_EQ(data[0]["a"], "chance-b");
  EXPECT_EQ(data[0]["ahead_a"], 1);
  EXPECT_EQ(data[0]["ahead_b"], 1);
  ASSERT_EQ(data[0]["kinds"].size(), 2);
  const Json& both = data[0]["kinds"][0];
  EXPECT_EQ(both["solved_by"], "both solve it");
  EXPECT_EQ(both["bars"][0]["problem"], "bowl-1");
  EXPECT_DOUBLE_EQ(both["bars"][0]["log2_ratio"], 2);
  EXPECT_EQ(both["bars"][0]["place"], 2);
  const Json& only = data[0]["kinds"][1];
  EXPECT_EQ(only["solved_by"], "only chance-b");
  EXPECT_DOUBLE_EQ(only["bars"][0]["log2_ratio"], -2.2);
  EXPECT_EQ(only["bars"][0]["place"], 1);
}

}  // namespace
}  // namespace ricochet::studies::comparison
