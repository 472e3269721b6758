#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "src/analysis/comparison/shares.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr int sampled_bowls = 20;
constexpr int made_up_solvers = 6;

/// A family of bowls of which the k-th is solved by the solvers from number k / 4 on, the best of
/// which are the fastest.
Json rows_of(double share) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {}}};
  for (int k = 0; k < sampled_bowls; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  catalogue.solvers.clear();
  for (int s = 0; s < made_up_solvers; ++s)
    catalogue.solvers.push_back(chance("s" + std::to_string(s)));
  const Campaign campaign(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 100\ninstances = 2\n",
                "test"),
      catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    const int k = std::stoi(cell.cell.problem.substr(5));
    const int s = std::stoi(cell.cell.solver.substr(1));
    Outcome outcome;
    outcome.evaluations = 100 - s;
    outcome.verdict.returned_solved = s >= k / 4;
    outcome.verdict.returned_optimality_gap = outcome.verdict.returned_solved ? 0 : 1;
    outcome.steps = {{outcome.evaluations, 0, *outcome.verdict.returned_optimality_gap}};
    return std::vector{outcome, outcome};
  });
  return sample_data(campaign, results, share, 3);
}

TEST(Sample, CoversEveryDifficulty) {
  const Json rows = rows_of(0.25);
  ASSERT_EQ(rows.size(), 1U);
  const Json& drawn = rows[0]["problems"];
  ASSERT_EQ(drawn.size(), 5U);
  EXPECT_EQ(rows[0]["of"], sampled_bowls);
  // Difficulties are 0, 1/6, ..., 4/6, each of four problems: a stratum each.
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(drawn[static_cast<std::size_t>(k)]["difficulty"].get<double>(), k / 6.0, 1e-12);
  }
  EXPECT_EQ(rows[0]["leader"], "s5, original");
  EXPECT_EQ(rows[0]["sample_leader"], "s5, original");
  EXPECT_NEAR(rows[0]["returned"].get<double>(), 1, 1e-12);
  EXPECT_EQ(rows[0]["best"], 1.0);
  EXPECT_NEAR(rows[0]["agreement"]["correlation"].get<double>(), 1, 1e-12);
}

TEST(Sample, HasAtLeastSoManyProblems) {
  EXPECT_EQ(rows_of(0.01)[0]["problems"].size(), 3U);
  EXPECT_EQ(rows_of(1)[0]["problems"].size(), static_cast<std::size_t>(sampled_bowls));
}

}  // namespace
}  // namespace ricochet::studies::comparison
