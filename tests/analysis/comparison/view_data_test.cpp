#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "src/analysis/comparison/view.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

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

report::Results view_of(const std::string& plan) {
  const Campaign campaign(plan_from(plan, "test"), made_up_catalogue());
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    std::vector<Outcome> runs;
    for (int k = 0; k < cell.instances * cell.seeds; ++k) {
      runs.push_back(run_after(cell.cell.problem == "bowl-1" ? k + 1 : 0));
    }
    return runs;
  });
  const auto parts = reported_parts(campaign);
  return view_page(campaign, results, parts, entry_sets_of(campaign, results, parts),
                   {campaign.solvers().front()});
}

const std::string two_bowls =
    "[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"chance-a\", \"chance-b\"]\n"
    "budgets = [100]\ninstances = 2\n";

TEST(ViewData, HasEveryRunOfAnEntryAndItsNames) {
  const report::Results view = view_of(two_bowls);
  const Table& entries = *view.table("view-entries");
  ASSERT_EQ(entries.rows.size(), 2U);
  const Row entry = entries[1];
  const Table& solvers = *view.table("view-solvers");
  EXPECT_EQ(solvers[0]["outside"], Value(false));
  EXPECT_EQ(solvers[1].text("solver"), "chance-b");
  EXPECT_EQ(solvers[1]["outside"], Value(true)) << "none of those that are known";
  EXPECT_EQ(entry.number("solver"), 1);
  EXPECT_EQ(entry.number("budget"), 100);
  EXPECT_EQ(entry.number("instances"), 2);
  EXPECT_EQ(entry.text("problems"), "") << "it takes all";
  EXPECT_EQ(*view.value("first_instance"), Value(std::int64_t{1}));
  const Table& problems = *view.table("view-problems");
  ASSERT_EQ(problems.rows.size(), 2U);
  EXPECT_EQ(problems[0].text("problem"), "bowl-1");
  // Two runs that miss nothing, then two that miss all targets, of which each left 10 or 110.
  EXPECT_EQ(entry.text("missing").substr(0, 2), "AA");
  EXPECT_EQ(entry.text("times"), "BAACAA");
  EXPECT_EQ(entry.text("spent").front(), 'A');
  EXPECT_EQ(entry.text("repeats"), "D") << "the last run is the one before it again";
  // On bowl-2 each run equals that of the entry before it: 1, in two bits, twice.
  const Table& orders = *view.table("view-orders");
  ASSERT_EQ(orders.rows.size(), 1U);
  EXPECT_EQ(orders[0].text("order"), "F");
}

TEST(ViewData, SaysWhichProblemsAnEntryTakesIfNotAll) {
  const report::Results view =
      view_of(two_bowls +
              "[[part]]\nname = \"more\"\nproblems = [\"bowl-1\", \"bowl-2\"]\n"
              "solvers = [\"chance-a\"]\nbudgets = [10]\ninstances = 1\n"
              "[[part]]\nname = \"again\"\nproblems = [\"bowl-2\"]\n"
              "solvers = [\"chance-b\"]\nbudgets = [10]\ninstances = 1\n");
  const Table& families = *view.table("view-families");
  ASSERT_EQ(families.rows.size(), 3U);
  EXPECT_EQ(families[0].text("family"), "bowl");
  EXPECT_EQ(families[0].text("problems"), "0 1");
  EXPECT_EQ(families[1].text("family"), "bowl-more");
  EXPECT_EQ(families[2].text("problems"), "1");
  const report::Results mixed = view_of(
      "[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\nsolvers = [\"chance-a\"]\n"
      "budgets = [10]\ninstances = 1\n"
      "[[part]]\nname = \"b\"\nproblems = [\"bowl-2\"]\nsolvers = [\"*\"]\n"
      "budgets = [10]\ninstances = 2\n");
  std::string taken;
  each_row(*mixed.table("view-entries"), [&](const Row& entry) {
    if (entry.number("family") == 0) taken += entry.text("problems") + ";";
  });
  EXPECT_EQ(taken, "10;01;") << "runs of other numbers are other entries";
}

}  // namespace
}  // namespace ricochet::studies::comparison
