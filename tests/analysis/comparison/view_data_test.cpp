#include <gtest/gtest.h>

#include <string>

#include "src/analysis/comparison/view.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A run that solved after so many evaluations, or spent 90.
Outcome run_after(std::int64_t solved) {
  Outcome outcome;
  outcome.evaluations = 90;
  outcome.verdict.returned_solved = solved > 0;
  outcome.verdict.returned_optimality_gap = solved > 0 ? 0 : 1e9;
  if (solved > 0) outcome.verdict.evaluations_to_solve = solved;
  outcome.steps = {{solved > 0 ? solved : 5, 0, solved > 0 ? 0.0 : 1e9}};
  return outcome;
}

Json view_of(const std::string& plan) {
  const Campaign campaign(plan_from(plan, "test"), made_up_catalogue());
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    std::vector<Outcome> runs;
    for (int k = 0; k < cell.instances * cell.seeds; ++k) {
      runs.push_back(run_after(cell.cell.problem == "bowl-1" ? k + 1 : 0));
    }
    return runs;
  });
  const auto parts = reported_parts(campaign);
  return view_data(campaign, results, parts, entry_sets_of(campaign, results, parts),
                   {campaign.solvers().front()});
}

const std::string two_bowls =
    "[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"chance-a\", \"chance-b\"]\n"
    "budgets = [100]\ninstances = 2\n";

TEST(ViewData, HasEveryRunOfAnEntryAndItsNames) {
  const Json view = view_of(two_bowls)["view"];
  ASSERT_EQ(view["entries"].size(), 2U);
  const Json& entry = view["entries"][1];
  EXPECT_EQ(view["solvers"][0]["outside"], false);
  EXPECT_EQ(view["solvers"][1]["solver"], "chance-b");
  EXPECT_EQ(view["solvers"][1]["outside"], true) << "none of those that are known";
  EXPECT_EQ(entry["solver"], 1);
  EXPECT_EQ(entry["budget"], 100);
  EXPECT_EQ(entry["instances"], 2);
  EXPECT_EQ(entry["problems"], "") << "it takes all";
  EXPECT_EQ(view["first_instance"], 1);
  const Json& problems = view["problems"];
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0]["problem"], "bowl-1");
  // Two runs that miss nothing, then two that miss all targets, of which each left 10 or 110.
  EXPECT_EQ(entry["missing"].get<std::string>().substr(0, 2), "AA");
  EXPECT_EQ(entry["times"], "BAACAA");
  EXPECT_EQ(entry["spent"].get<std::string>().front(), 'A');
  EXPECT_EQ(entry["repeats"], "D") << "the last run is the one before it again";
  // On bowl-2 each run equals that of the entry before it: 1, in two bits, twice.
  EXPECT_EQ(view["orders"], Json({"F"}));
}

TEST(ViewData, SaysWhichProblemsAnEntryTakesIfNotAll) {
  const Json view = view_of(two_bowls +
                            "[[part]]\nname = \"more\"\nproblems = [\"bowl-1\", \"bowl-2\"]\n"
                            "solvers = [\"chance-a\"]\nbudgets = [10]\ninstances = 1\n"
                            "[[part]]\nname = \"again\"\nproblems = [\"bowl-2\"]\n"
                            "solvers = [\"chance-b\"]\nbudgets = [10]\ninstances = 1\n")["view"];
  ASSERT_EQ(view["families"].size(), 3U);
  EXPECT_EQ(view["families"][0]["family"], "bowl");
  EXPECT_EQ(view["families"][1]["family"], "bowl-more");
  EXPECT_EQ(view["families"][2]["problems"], Json({1}));
  const Json mixed = view_of(
      "[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"chance-a\"]\n"
      "budgets = [10]\ninstances = 1\n"
      "[[part]]\nname = \"b\"\nproblems = [\"bowl-2\"]\nsolvers = [\"*\"]\n"
      "budgets = [10]\ninstances = 2\n")["view"];
  std::string taken;
  for (const Json& entry : mixed["entries"]) {
    if (entry["family"] == 0) taken += entry["problems"].get<std::string>() + ";";
  }
  EXPECT_EQ(taken, "10;01;") << "runs of other numbers are other entries";
}

TEST(ViewData, TellsTheReaderWhatThereIs) {
  const Json rows = view_of(two_bowls)["families"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["family"], "bowl");
  EXPECT_EQ(rows[0]["problems"], 2);
  EXPECT_EQ(rows[0]["entries"], 2);
  EXPECT_EQ(rows[0]["runs"], 8);
  EXPECT_EQ(rows[0]["budgets"], "100");
}

}  // namespace
}  // namespace ricochet::studies::comparison
