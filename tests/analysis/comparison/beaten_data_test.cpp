#include <gtest/gtest.h>

#include "src/analysis/comparison/order.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Two bowls; the runs of "bowl-1" end with these optimality gaps, those of "bowl-2" with 0.
Json rows_of(const std::vector<std::optional<double>>& gaps) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {bowl("bowl-1", 1), bowl("bowl-2", 1)}}};
  catalogue.solvers = {chance("guess")};
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 1\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [&](const PlannedCell& cell) {
    std::vector<Outcome> outcomes;
    for (const auto& gap : gaps) {
      Outcome outcome;
      outcome.verdict.optimality_gap = cell.cell.problem == "bowl-1" ? gap : 0;
      outcomes.push_back(outcome);
    }
    return outcomes;
  });
  return beaten_data(campaign, results);
}

TEST(Beaten, BestValuesAreThoseBelowWhichARunEndsByMoreThanTheTolerance) {
  const double tolerance = bowl("bowl-1", 1).tolerance;
  const Json rows = rows_of({0.5, -1.5 * tolerance, std::nullopt, -3 * tolerance});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["problem"], "bowl-1");
  EXPECT_EQ(rows[0]["runs"], 2);
  EXPECT_EQ(rows[0]["gap"], -3 * tolerance);
  EXPECT_EQ(rows[0]["solver"], "guess");
}

TEST(Beaten, NothingIsWithinTheTolerance) {
  EXPECT_EQ(rows_of({0, -0.9 * bowl("bowl-1", 1).tolerance, std::nullopt}), Json::array());
}

}  // namespace
}  // namespace ricochet::studies::comparison
