#include <gtest/gtest.h>

#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Bowls and as many solvers as asked for; the k-th solves every problem after k evaluations.
Json rows_of(int problems, int solvers) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.solvers.clear();
  for (int k = 1; k <= solvers; ++k) catalogue.solvers.push_back(chance("s" + std::to_string(k)));
  catalogue.families = {{"bowl", {}}};
  for (int k = 1; k <= problems; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 1\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    Outcome outcome;
    outcome.evaluations = 100;
    outcome.verdict.solved = outcome.verdict.returned_solved = true;
    outcome.verdict.evaluations_to_solve = std::stoi(cell.cell.solver.substr(1));
    outcome.verdict.optimality_gap = outcome.verdict.returned_optimality_gap = 0;
    outcome.steps = {{*outcome.verdict.evaluations_to_solve, 0.1, 0}};
    return std::vector{outcome};
  });
  const Comparison comparison = comparison_of(campaign, results, {});
  return held_out_data(comparison, groups_of(comparison));
}

TEST(HeldOut, OrderIsThatOfTheOtherHalf) {
  const Json rows = rows_of(6, 5);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["family"], "bowl");
  EXPECT_EQ(rows[0]["problems"], 6);
  EXPECT_EQ(rows[0]["entries"], 5);
  EXPECT_EQ(rows[0]["measured"], true);
  EXPECT_EQ(rows[0]["correlation"], 1);
  EXPECT_EQ(rows[0]["first_stays"], 1);
}

TEST(HeldOut, OrderOfFewProblemsOrEntriesIsNotMeasured) {
  for (const Json& rows : {rows_of(3, 5), rows_of(6, 4)}) {
    EXPECT_EQ(rows[0]["measured"], false);
    EXPECT_FALSE(rows[0].contains("correlation"));
  }
}

}  // namespace
}  // namespace ricochet::studies::comparison
