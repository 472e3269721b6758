#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/pairs.h"
#include "src/analysis/comparison/sections.h"
#include "tests/analysis/comparison/made_up_results.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

/// A run of 100 evaluations that solved after so many, or not at all.
Outcome run_solved_after(std::optional<std::int64_t> solved) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.seconds = 2;
  outcome.verdict.solved = solved.has_value();
  outcome.verdict.evaluations_to_solve = solved;
  if (solved) outcome.verdict.seconds_to_solve = 0.01 * static_cast<double>(*solved);
  outcome.verdict.returned_solved = outcome.verdict.solved;
  outcome.verdict.optimality_gap = solved ? 0.0 : 3.0;
  outcome.verdict.returned_optimality_gap = outcome.verdict.optimality_gap;
  outcome.steps = {{solved.value_or(50), 0.1, *outcome.verdict.optimality_gap}};
  return outcome;
}

Campaign campaign_of(const std::string& problems, const std::string& solvers) {
  return Campaign(plan_from("name = \"t\"\n[[part]]\nproblems = [" + problems + "]\nsolvers = [" +
                                solvers + "]\nbudgets = [100]\ninstances = 2\n",
                            "test"),
                  made_up_catalogue());
}

/// All cells with two runs each: chance-a solves one of the first problem after 10 evaluations,
/// and both of others after 40; chance-b all after 50; luck none.
std::vector<CellResult> results_of(const Campaign& campaign) {
  return made_up_results(campaign, [](const PlannedCell& cell) {
    if (cell.cell.solver == "luck") return std::vector{run_solved_after({}), run_solved_after({})};
    if (cell.cell.solver == "chance-b") {
      return std::vector{run_solved_after(50), run_solved_after(50)};
    }
    return cell.cell.problem == "bowl-1" ? std::vector{run_solved_after(10), run_solved_after({})}
                                         : std::vector{run_solved_after(40), run_solved_after(40)};
  });
}

std::vector<EntrySet> entry_sets_of(const Campaign& campaign,
                                    const std::vector<CellResult>& results) {
  return comparison::entry_sets_of(campaign, results, reported_parts(campaign));
}

Json row_of(const Json& rows, const std::string& solver) {
  for (const Json& row : rows) {
    if (row["solver"] == solver) return row;
  }
  return {};
}

TEST(SpeedAccuracy, IsWhatTheRunsCountUpTo) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  const auto results = results_of(campaign);
  const Json data = speed_accuracy_data(campaign, entry_sets_of(campaign, results));
  ASSERT_EQ(data["speed_accuracy"].size(), 3);
  const Json a = row_of(data["speed_accuracy"], "chance-a");
  // 10 and 100 of one variable; 40 and 40 of two.
  EXPECT_NEAR(a["evaluations"].get<double>(), std::sqrt(55.0 * 20.0), 1e-9);
  EXPECT_NEAR(a["seconds"].get<double>(), std::sqrt((0.1 + 2) / 2 * 0.4), 1e-9);
  EXPECT_EQ(a["share"], 0.75);
  EXPECT_LT(a["share_lower"].get<double>(), 0.75);
  EXPECT_GT(a["share_upper"].get<double>(), 0.75);
  EXPECT_EQ(a["optimality_gap"], 0.75);  // the median of 1.5 and 0
  EXPECT_TRUE(a["optimality_gap_lower"].is_null());
  EXPECT_EQ(a["runs"], 4);
  EXPECT_EQ(a["part"], 1);
  EXPECT_TRUE(a["complete"].get<bool>());
  const Json b = row_of(data["speed_accuracy"], "chance-b");
  EXPECT_NEAR(b["evaluations"].get<double>(), std::sqrt(50.0 * 25.0), 1e-9);
  EXPECT_EQ(b["share"], 1);
  EXPECT_TRUE(a["on_front"].get<bool>());
  EXPECT_TRUE(b["on_front"].get<bool>());
  EXPECT_FALSE(row_of(data["speed_accuracy"], "luck")["on_front"].get<bool>());
  ASSERT_EQ(data["speed_accuracy_charts"].size(), 2);  // evaluations and seconds
  EXPECT_EQ(data["speed_accuracy_charts"][0]["leading"], 2);
  EXPECT_EQ(data["speed_accuracy_charts"][0]["surest"], "chance-b");
}

TEST(SpeedAccuracy, LeavesWhoTakesSomeOnlyOffTheFront) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  auto results = results_of(campaign);
  std::erase_if(results, [](const CellResult& s) {
    return s.cell->cell.solver == "chance-a" && s.cell->cell.problem == "bowl-1";
  });
  const Json rows =
      speed_accuracy_data(campaign, entry_sets_of(campaign, results))["speed_accuracy"];
  EXPECT_FALSE(row_of(rows, "chance-a")["complete"].get<bool>());
  EXPECT_FALSE(row_of(rows, "chance-a")["on_front"].get<bool>());
  EXPECT_TRUE(row_of(rows, "chance-b")["on_front"].get<bool>());
}

TEST(SpeedAccuracy, JoinsFamiliesOfWhichEachSolverTakesAll) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"cup-s\"", "\"*\"");
  const auto results = results_of(campaign);
  const Json data = speed_accuracy_data(campaign, entry_sets_of(campaign, results));
  const Json& all = data["speed_accuracy"][0];
  EXPECT_EQ(all["family"], "all");
  EXPECT_TRUE(all["budget"].is_null());
  EXPECT_EQ(all["solver"], "chance-a");
  EXPECT_EQ(all["share"], 0.75);
}

TEST(SpeedAccuracy, OfNothingOrOneIsNothingOrOne) {
  const Campaign campaign = campaign_of("\"bowl-1\"", "\"luck\"");
  const Json none = speed_accuracy_data(campaign, {});
  EXPECT_TRUE(none["speed_accuracy"].empty());
  const auto results = results_of(campaign);
  const auto sets = entry_sets_of(campaign, results);
  const Json one = speed_accuracy_data(campaign, sets);
  EXPECT_EQ(one["speed_accuracy"].size(), 1);
  EXPECT_EQ(one["speed_accuracy"][0]["share"], 0);
  EXPECT_TRUE(profile_data(campaign, sets).empty());
  EXPECT_TRUE(pair_data(campaign, sets).empty());
}

TEST(Profiles, AreOfTheRatiosToTheLeast) {
  const Campaign campaign = campaign_of("\"bowl-1\", \"bowl-2\"", "\"*\"");
  const auto results = results_of(campaign);
  const Json data = profile_data(campaign, entry_sets_of(campaign, results));
  ASSERT_EQ(data.size(), 1);
  // Expected running times: 110 and 20 of chance-a, 50 and 25 of chance-b.
  const Json a = row_of(data[0]["rows"], "chance-a");
  const Json b = row_of(data[0]["rows"], "chance-b");
  EXPECT_EQ(a["least"], 0.5);
  EXPECT_EQ(a["twice"], 0.5);
  EXPECT_EQ(a["tenfold"], 1);
  EXPECT_EQ(b["twice"], 1);
  EXPECT_EQ(b["alone"], 0.5);
  EXPECT_EQ(row_of(data[0]["rows"], "luck")["solved"], 0);
  // PAR10: (10 + 1000) / 2 and 20; 50 and 25; the least of both 50 and 20.
  EXPECT_NEAR(a["cost"].get<double>(), std::sqrt(505.0 * 20), 1e-9);
  EXPECT_EQ(data[0]["single_best"], "chance-b");
  EXPECT_NEAR(data[0]["virtual_best_cost"].get<double>(), std::sqrt(1000.0), 1e-9);
  EXPECT_NEAR(data[0]["gap"].get<double>(), std::sqrt(1250.0 / 1000.0), 1e-9);
}

TEST(Pairs, SayWhoIsBetterAndWhere) {
  const Campaign campaign = campaign_of("\"bowl-*\"", "\"chance-b\", \"luck\"");
  const auto results = results_of(campaign);
  const Json data = pair_data(campaign, entry_sets_of(campaign, results));
  ASSERT_EQ(data.size(), 1);
  ASSERT_EQ(data[0]["pairs"].size(), 1);
  const Json& pair = data[0]["pairs"][0];
  EXPECT_EQ(pair["a"], "chance-b");
  EXPECT_GT(pair["better"].get<double>(), 0.9);
  EXPECT_NEAR(
      pair["better"].get<double>() + pair["equivalent"].get<double>() + pair["worse"].get<double>(),
      1, 1e-9);
  EXPECT_EQ(pair["a_faster"], 0);  // two runs on each side say nothing
  // At an optimality gap of one tolerance: all runs of one, none of the other, from 50 evaluations
  // on.
  const Json& cells = data[0]["map"]["rows"][0]["cells"];
  EXPECT_EQ(cells.front(), 0);
  EXPECT_EQ(cells.back(), 1);
}

}  // namespace
}  // namespace ricochet::studies::comparison
