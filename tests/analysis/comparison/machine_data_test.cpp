#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/experiment/stored_campaign.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// Bowls of machines: restitution 0.1 and 0.9, friction 0 and 1, these disturbances; the best value
/// is the product of the first two.
Campaign campaign_of(const std::vector<double>& disturbances) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [=](const MachineGrid&) {
    std::vector<SearchedProblem> problems;
    for (const double restitution : {0.1, 0.9}) {
      for (const double friction : {0.0, 1.0}) {
        for (const double disturbance : disturbances) {
          const std::string machine = "M" + std::to_string(problems.size());
          Problem problem = bowl("bowl-" + machine, 1);
          problem.machine = machine;
          problem.factors = {
              {"restitution", restitution}, {"friction", friction}, {"disturbance", disturbance}};
          problem.best_known = restitution * friction;
          problems.push_back(searched(problem, nullptr));
        }
      }
    }
    return problems;
  };
  return searched_campaign(
      plan_from("name = \"t\"\n[[part]]\nproblems = \"*\"\nsolvers = [\"chance-*\"]\n"
                "budgets = [100]\ninstances = 1\n"
                "machines = {around = \"C1\", restitution = [0.1, 0.9], friction = [0, 1]}\n",
                "test"),
      catalogue);
}

/// chance-a solves at the high friction only; the others never solve, and throw.
std::vector<CellResult> made_up_machine_results(const Campaign& campaign) {
  return made_up_results(campaign, [&](const PlannedCell& cell) {
    const Problem& problem = campaign.problems()[cell.problem];
    Outcome outcome;
    outcome.evaluations = cell.budget.evaluations;
    outcome.verdict.feasible = true;
    outcome.verdict.returned_solved =
        cell.cell.solver == "chance-a" && problem.factors.at("friction") == 1;
    outcome.verdict.solved = outcome.verdict.returned_solved;
    if (cell.cell.solver != "chance-a") outcome.failure = "threw: no";
    return std::vector{outcome};
  });
}

class Machines : public testing::Test {
 protected:
  const Campaign campaign_ = campaign_of({0});
  const std::vector<CellResult> results_ = made_up_machine_results(campaign_);
};

TEST_F(Machines, HaveMapsOverTheirConstants) {
  const Json data = machine_data(campaign_, results_, reported_parts(campaign_));
  ASSERT_EQ(data["machines"].size(), 1U);
  const Json& known = data["machines"][0];
  EXPECT_EQ(known["column"], "friction");
  EXPECT_EQ(known["columns"], (Json{{{"level", "0"}}, {{"level", "1"}}}));
  EXPECT_EQ(known["first"], "chance-a, original");
  EXPECT_EQ(known["first_share"], 0.5);
  ASSERT_EQ(known["known"].size(), 2U);
  EXPECT_EQ(known["known"][0]["machine"], "restitution 0.1");
  EXPECT_EQ(known["known"][0]["cells"], (Json{0.0, 0.1}));
  EXPECT_EQ(known["known"][1]["cells"], (Json{0.0, 0.9}));
  ASSERT_EQ(data["machine_maps"].size(), 2U);
  EXPECT_EQ(data["machine_maps"][0]["entry"], "chance-a, original");
  EXPECT_EQ(data["machine_maps"][0]["rows"][1]["cells"], (Json{0.0, 1.0}));
  EXPECT_EQ(data["machine_maps"][1]["rows"][1]["cells"], (Json{0.0, 0.0}));
}

TEST_F(Machines, HaveALandscapeEach) {
  const Json data = machine_data(campaign_, results_, reported_parts(campaign_));
  ASSERT_EQ(data["landscapes"].size(), 1U);
  const Json& landscape = data["landscapes"][0];
  const Problem& stated = campaign_.problems().front();
  EXPECT_EQ(landscape["columns"].front()["at"], fmt::format("{:.3g}", stated.lower[0]));
  EXPECT_EQ(landscape["columns"].back()["at"], fmt::format("{:.3g}", stated.upper[0]));
  ASSERT_EQ(landscape["rows"].size(), 4U);
  const Json& row = landscape["rows"][2];
  EXPECT_EQ(row["machine"], "friction 0, restitution 0.9");
  ASSERT_EQ(row["cells"].size(), landscape["columns"].size());
  EXPECT_EQ(row["cells"].front(), true_values_at(stated, stated.lower).objective);
  EXPECT_EQ(row["cells"].back(), true_values_at(stated, stated.upper).objective);
}

TEST_F(Machines, HaveMainEffectsInTheOrderOfTheirLevels) {
  const Campaign campaign = campaign_of({0, 1});
  const auto results = made_up_machine_results(campaign);
  const Json data = factor_data(campaign, results, reported_parts(campaign));
  ASSERT_EQ(data["main_effects"].size(), 1U);
  const Json& effects = data["main_effects"][0];
  EXPECT_EQ(effects["levels"], (Json{{{"level", "disturbance 0"}},
                                     {{"level", "disturbance 1"}},
                                     {{"level", "friction 0"}},
                                     {{"level", "friction 1"}},
                                     {{"level", "restitution 0.1"}},
                                     {{"level", "restitution 0.9"}}}));
  const Json& first = effects["entries"][0];
  EXPECT_EQ(first["entry"], "chance-a, original");
  ASSERT_EQ(first["effects"].size(), 6U);
  EXPECT_DOUBLE_EQ(first["effects"][2]["effect"], -0.5);
  EXPECT_DOUBLE_EQ(first["effects"][3]["effect"], 0.5);
  EXPECT_NEAR(first["effects"][4]["effect"].get<double>(), 0, 1e-12);
}

TEST_F(Machines, HaveAnAtlasOfHowRunsEnded) {
  const Json data = atlas_data(campaign_, results_);
  ASSERT_EQ(data["atlas_maps"].size(), 3U);
  EXPECT_EQ(data["atlas_maps"][0]["kind"], "solved");
  const Json& rows = data["atlas_maps"][0]["rows"];
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0]["machine"], "M0: 0.1, 0, 0");
  EXPECT_EQ(rows[0]["cells"], (Json{0.0}));
  EXPECT_EQ(rows[1]["cells"], (Json{0.5}));
  for (const Json& map : data["atlas_maps"]) {
    if (map["kind"] == "threw") {
      EXPECT_EQ(map["most"], 0.5);
    }
    if (map["kind"] == "budget spent") {
      EXPECT_EQ(map["rows"][0]["cells"], (Json{0.5}));
      EXPECT_EQ(map["rows"][1]["cells"], (Json{0.0}));
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::comparison
