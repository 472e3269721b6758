#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr int own_bowls = 8;

/// A family of eight bowls, which "weak" never solves, "mine" always, "equal" too, and "strong" not
/// the first of them.
Json data_of(const std::vector<Solver>& suite) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"bowl", {}}};
  for (int k = 1; k <= own_bowls; ++k) {
    catalogue.families[0].problems.push_back(bowl("bowl-" + std::to_string(k), 1));
  }
  catalogue.solvers = {chance("weak"), chance("equal"), chance("strong")};
  const Campaign campaign(plan_from("[[part]]\nproblems = \"*\"\nsolvers = [\"*\", \"./mine\"]\n"
                                    "budgets = 100\ninstances = 2\n",
                                    "test"),
                          catalogue);
  const auto results = made_up_results(campaign, [](const PlannedCell& cell) {
    Outcome outcome;
    outcome.evaluations = 100;
    outcome.verdict.returned_solved =
        cell.cell.solver != "weak" &&
        !(cell.cell.solver == "strong" && cell.cell.problem == "bowl-1");
    return std::vector{outcome, outcome};
  });
  return own_solver_data(campaign, entry_sets_of(campaign, results, reported_parts(campaign)),
                         suite);
}

TEST(OwnSolver, StandsBesideTheOthersOfItsFamily) {
  const Json data = data_of({chance("weak"), chance("equal"), chance("strong")});
  ASSERT_EQ(data["own_solvers"].size(), 1U);
  const Json& row = data["own_solvers"][0];
  EXPECT_EQ(row["solver"], "mine");
  EXPECT_EQ(row["family"], "bowl");
  EXPECT_EQ(row["share"], 1.0);
  EXPECT_LT(row["lower"].get<double>(), 0.9);
  EXPECT_EQ(row["rivals"], 3);
  EXPECT_EQ(row["better"], 2) << "weak and strong";
  EXPECT_EQ(row["worse"], 0);
  EXPECT_EQ(row["clearly_better"], 1) << "weak: eight of eight differ; strong: one";
  const Json& total = data["own_totals"][0];
  EXPECT_EQ(total["solved"], own_bowls);
  EXPECT_EQ(total["problems"], own_bowls);
}

TEST(OwnSolver, IsNoneOfTheSuite) {
  const Json data = data_of({chance("weak"), chance("equal"), chance("strong"), chance("mine")});
  EXPECT_TRUE(data["own_solvers"].empty());
  EXPECT_TRUE(data["own_totals"].empty());
}

}  // namespace
}  // namespace ricochet::studies::comparison
