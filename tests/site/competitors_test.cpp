#include "src/site/competitors.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/site/made_up_reports.h"

namespace ricochet::site {
namespace {

/// What a row has in the column.
Json value(const Json& contest, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < contest["columns"].size(); ++i) {
    if (contest["columns"][i] == column) return contest["rows"][row][i];
  }
  throw std::out_of_range(column);
}

Json contest_of(const Json& data) {
  return contest_data({made_up("contest", data, "contest")});
}

Json fast(const char* family, const Json& budget, const char* solver, double share) {
  return {{"family", family},       {"budget", budget},  {"solver", solver},
          {"form", "count"},        {"complete", true},  {"evaluations", 7.5},
          {"seconds", 0.25},        {"share", share},    {"share_lower", 0.1},
          {"share_upper", 0.95},    {"regret", nullptr}, {"regret_lower", nullptr},
          {"regret_upper", nullptr}};
}

TEST(ContestData, HasARowForEachCompetitorAndBudgetInItsOrder) {
  const Json contest = contest_of(small_contest());
  ASSERT_EQ(contest["rows"].size(), 4);
  for (const Json& row : contest["rows"]) EXPECT_EQ(row.size(), contest["columns"].size());
  EXPECT_EQ(value(contest, 1, "solver"), "mine");
  EXPECT_EQ(value(contest, 1, "place"), 2);
  EXPECT_EQ(value(contest, 1, "outside"), true);
  EXPECT_EQ(value(contest, 2, "budget"), 100);
  EXPECT_EQ(value(contest, 2, "targets"), 0.75);
  EXPECT_TRUE(value(contest, 2, "evaluations").is_null());
  EXPECT_EQ(contest["families"][0]["variables"], (Json{{"least", 1}, {"most", 3}}));
}

TEST(ContestData, TellsSpeedAndAccuracyOfTheCompetitorTheyBelongTo) {
  Json data = small_contest();
  data["speed_accuracy"] = {fast("count", 100, "mine", 0.5)};
  const Json contest = contest_of(data);
  EXPECT_TRUE(value(contest, 1, "evaluations").is_null());  // of the other budget
  EXPECT_TRUE(value(contest, 2, "evaluations").is_null());  // of the other solver
  EXPECT_EQ(value(contest, 3, "evaluations"), 7.5);
  EXPECT_EQ(value(contest, 3, "solved"), 0.5);
  EXPECT_EQ(value(contest, 3, "solved_upper"), 0.95);
  EXPECT_TRUE(value(contest, 3, "error").is_null());
  EXPECT_EQ(value(contest, 3, "complete"), true);
}

TEST(ContestData, HasOfManyTheFirstAndThoseThatThePageIsAbout) {
  Json data = small_contest();
  Json& ratings = data["groups"][0]["budgets"][0]["ratings"];
  const Json mine = ratings[1];
  for (int k = 0; k < 40; ++k) {
    Json other = ratings[0];
    other["solver"] = "s" + std::to_string(k);
    ratings.push_back(other);
  }
  ratings.push_back(mine);  // from outside
  const Json& budget = data["groups"][0]["budgets"][0]["budget"];
  data["speed_accuracy"] = {fast("count", budget, "s35", 0.5)};
  const Json contest = contest_of(data);
  ASSERT_EQ(contest["rows"].size(), 15 + 2 + 2) << "the other budget has two";
  EXPECT_EQ(value(contest, 14, "place"), 15);
  EXPECT_EQ(value(contest, 15, "solver"), "s35");
  EXPECT_EQ(value(contest, 15, "place"), 38);
  EXPECT_EQ(value(contest, 16, "solver"), "mine");
  EXPECT_EQ(value(contest, 16, "place"), 43);
}

TEST(ContestData, HasAllFamiliesTogetherFirstBestFirst) {
  Json data = small_contest();
  data["speed_accuracy"] = {fast("all", nullptr, "mine", 0.5), fast("all", nullptr, "scan", 0.6)};
  const Json contest = contest_of(data);
  EXPECT_EQ(contest["families"][0]["name"], "all");
  ASSERT_EQ(contest["rows"].size(), 6);
  EXPECT_EQ(value(contest, 0, "solver"), "scan");
  EXPECT_EQ(value(contest, 0, "budget"), 0);
  EXPECT_TRUE(value(contest, 0, "best").is_null());
  EXPECT_EQ(value(contest, 2, "family"), 1);
}

TEST(ContestData, LeavesOutTheMidstOfALevelCurve) {
  const Json contest = contest_of(small_contest());
  EXPECT_EQ(contest["curves"][0]["points"].dump(), "[[1.0,0.0],[4.0,0.0],[8.0,0.5]]");
}

}  // namespace
}  // namespace ricochet::site
