#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "src/analysis/comparison/order.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// The last row for two bowls, which random search solves after so many evaluations, or never, and
/// another solver after one.
Json last_row(const std::optional<std::int64_t>& random) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.solvers = {chance("random-search"), chance("fast")};
  const Campaign campaign(plan_from("[[part]]\nproblems = [\"bowl-1\", \"bowl-2\"]\n"
                                    "solvers = \"*\"\nbudgets = [10, 100]\ninstances = 2\n",
                                    "test"),
                          catalogue);
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    Outcome outcome;
    const auto after = cell.cell.solver == "fast" ? std::optional<std::int64_t>(1) : random;
    outcome.evaluations = 100;
    outcome.verdict.solved = outcome.verdict.returned_solved = after.has_value();
    outcome.verdict.evaluations_to_solve = after;
    outcome.verdict.optimality_gap = outcome.verdict.returned_optimality_gap = after ? 0 : 1;
    outcome.steps = {{after.value_or(5), 0, *outcome.verdict.optimality_gap}};
    return std::vector{outcome, outcome};
  });
  const Comparison comparison = comparison_of(campaign, results, {});
  const std::vector<Group> groups = groups_of(comparison);
  const Json rows = group_data(comparison, groups, ratings_of(comparison, groups));
  const Json leaders = leader_data(comparison, groups, rows);
  EXPECT_EQ(leaders.size(), 2U);
  EXPECT_EQ(leaders.at(0)["largest"], false);
  return leaders.at(1);
}

TEST(Leaders, AreNamedWhereRandomSearchIsSlow) {
  const Json row = last_row(21);
  EXPECT_EQ(row["solver"], "fast");
  EXPECT_EQ(row["budget"], 100);
  EXPECT_EQ(row["largest"], true);
  EXPECT_EQ(row["random"], 21.0);
  EXPECT_EQ(row["easy"], false);
  const Json never = last_row(std::nullopt);
  EXPECT_EQ(never["solver"], "fast");
  EXPECT_TRUE(never["random"].is_null());
  EXPECT_EQ(never["easy"], false);
}

TEST(Leaders, AreNotNamedWhereRandomSearchSolvesAtOnce) {
  const Json row = last_row(20);
  EXPECT_EQ(row["easy"], true);
  EXPECT_EQ(row["random"], 20.0);
  EXPECT_TRUE(row["solver"].is_null());
  EXPECT_EQ(row["family"], "bowl");
}

}  // namespace
}  // namespace ricochet::studies::comparison
