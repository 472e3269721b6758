#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/experiment/stored_campaign.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

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

report::Results maps_of(const Campaign& campaign, const std::vector<CellResult>& results) {
  const std::vector<ReportedPart> reported = reported_parts(campaign);
  const report::Results page = machines_page(rated_parts(campaign, results, reported));
  return page.parts.at("families").at(0).results;
}

using Cells = std::vector<std::optional<double>>;

TEST_F(Machines, HaveMapsOverTheirConstants) {
  const report::Results page = maps_of(campaign_, results_);
  const report::Chart& known = *page.chart("known");
  EXPECT_EQ(known.x.label, "friction");
  EXPECT_EQ(known.x.categories, (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(known.y.categories, (std::vector<std::string>{"restitution 0.9", "restitution 0.1"}));
  EXPECT_EQ(known.heat_map->rows, (std::vector<Cells>{{0.0, 0.9}, {0.0, 0.1}}));
  EXPECT_EQ(known.title, "bowl: best known values of 0 to 0.9");
}

TEST_F(Machines, HaveALandscapeEach) {
  const report::Chart landscape = *maps_of(campaign_, results_).chart("landscape");
  const Problem& stated = campaign_.problems().front();
  EXPECT_EQ(landscape.x.categories.front(), fmt::format("{:.3g}", stated.lower[0]));
  EXPECT_EQ(landscape.x.categories.back(), fmt::format("{:.3g}", stated.upper[0]));
  ASSERT_EQ(landscape.heat_map->rows.size(), 4U);
  EXPECT_EQ(landscape.y.categories[1], "friction 0, restitution 0.9");
  const Cells& row = landscape.heat_map->rows[1];
  ASSERT_EQ(row.size(), landscape.x.categories.size());
  EXPECT_EQ(row.front(), true_values_at(stated, stated.lower).objective);
  EXPECT_EQ(row.back(), true_values_at(stated, stated.upper).objective);
}

TEST_F(Machines, SayWhoIsFirstAtEachLevel) {
  const report::Results page = maps_of(campaign_, results_);
  const Table& levels = *page.table("levels");
  ASSERT_EQ(levels.rows.size(), 4U);
  EXPECT_EQ(levels[0].text("first"), "none") << "at no friction nobody solves";
  EXPECT_EQ(levels[1].text("changed"), "friction");
  EXPECT_EQ(levels[1].text("setting"), "1");
  EXPECT_EQ(levels[1].text("first"), "chance-a, original");
  EXPECT_EQ(levels[1].number("returned"), 1);
  EXPECT_FALSE(levels[1].is("same"));
}

TEST(MachinesPage, HasNoFamilyWithoutAGrid) {
  const Campaign campaign(plan_from("[[part]]\nproblems = \"bowl-1\"\nsolvers = \"*\"\nbudgets = "
                                    "10\ninstances = 1\n",
                                    "test"),
                          made_up_catalogue());
  const auto results =
      made_up_results(campaign, [](const PlannedCell&) { return std::vector{Outcome()}; });
  const std::vector<ReportedPart> reported = reported_parts(campaign);
  EXPECT_TRUE(machines_page(rated_parts(campaign, results, reported)).parts.empty());
}

}  // namespace
}  // namespace ricochet::studies::comparison
