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
  report::Results page;
  const auto parts = reported_parts(campaign);
  const auto families = machine_results(campaign, results, parts.at(0));
  add_machine_maps("bowl", families.at("bowl"), page);
  add_effects("bowl", families.at("bowl"), page);
  return page;
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
  EXPECT_EQ(*page.value("finding"),
            Value("bowl: best known values of 0 to 0.9; chance-a, original solves most (50 %)."));
  EXPECT_EQ(page.chart("solved")->heat_map->rows, (std::vector<Cells>{{0.0, 100.0}, {0.0, 100.0}}));
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

TEST_F(Machines, HaveMainEffectsInTheOrderOfTheirLevels) {
  const Campaign campaign = campaign_of({0, 1});
  const auto results = made_up_machine_results(campaign);
  const report::Chart effects = *maps_of(campaign, results).chart("effects");
  EXPECT_EQ(effects.x.categories,
            (std::vector<std::string>{"disturbance 0", "disturbance 1", "friction 0", "friction 1",
                                      "restitution 0.1", "restitution 0.9"}));
  const report::Series& first = effects.series.at(0);
  EXPECT_EQ(first.label, "chance-a, original");
  ASSERT_EQ(first.samples.size(), 6U);
  EXPECT_DOUBLE_EQ(*first.samples[2].value, -50);
  EXPECT_DOUBLE_EQ(*first.samples[3].value, 50);
  EXPECT_NEAR(*first.samples[4].value, 0, 1e-10);
}

TEST_F(Machines, SayWhoSolvesMostAtEachLevel) {
  const report::Results page = maps_of(campaign_, results_);
  const Table& levels = *page.table("levels");
  ASSERT_EQ(levels.rows.size(), 4U);
  EXPECT_EQ(levels[1].text("factor"), "friction");
  EXPECT_EQ(levels[1].text("level"), "1");
  EXPECT_EQ(levels[1].text("first"), "chance-a, original");
  EXPECT_EQ(levels[1].number("share"), 1);
  EXPECT_EQ(levels[2].number("share_of_overall"), 0.5);
}

TEST_F(Machines, HaveAnAtlasOfHowRunsEnded) {
  report::Results page;
  add_atlas(campaign_, results_, page);
  const std::vector<report::Part>& outcomes = page.parts.at("outcomes");
  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_EQ(outcomes[0].id, "solved");
  const auto row_of = [&](const report::Part& part, const std::string& machine) {
    const report::Chart& chart = part.results.charts.at(0);
    const auto place = std::ranges::find(chart.y.categories, machine);
    return chart.heat_map->rows.at(static_cast<std::size_t>(place - chart.y.categories.begin()));
  };
  EXPECT_EQ(row_of(outcomes[0], "M0: 0.1, 0, 0"), Cells{0.0});
  EXPECT_EQ(row_of(outcomes[0], "M1: 0.1, 1, 0"), Cells{50.0});
  for (const report::Part& part : outcomes) {
    if (part.id == "threw") {
      EXPECT_EQ(row_of(part, "M1: 0.1, 1, 0"), Cells{50.0});
    }
    if (part.id == "budget-spent") {
      EXPECT_EQ(row_of(part, "M0: 0.1, 0, 0"), Cells{50.0});
      EXPECT_EQ(row_of(part, "M1: 0.1, 1, 0"), Cells{0.0});
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::comparison
