#include "src/report/site/entries.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

Json fast(const char* family, const Json& budget, const char* solver, double share) {
  return {{"family", family},
          {"budget", budget},
          {"largest", true},
          {"solver", solver},
          {"formulation", "count"},
          {"complete", true},
          {"evaluations", 7.5},
          {"seconds", 0.25},
          {"share", share},
          {"share_lower", 0.1},
          {"share_upper", 0.95},
          {"optimality_gap", nullptr},
          {"optimality_gap_lower", nullptr},
          {"optimality_gap_upper", nullptr}};
}

TEST(Entries, AreThoseOfEachBudgetInTheirOrder) {
  const Comparison comparison = comparison_of(found_comparison());
  ASSERT_EQ(comparison.entries.size(), 4U);
  const Entry& mine = comparison.entries[1];
  EXPECT_EQ(mine.solver, "mine");
  EXPECT_EQ(mine.place, 2U);
  EXPECT_EQ(mine.of, 2U);
  EXPECT_TRUE(mine.outside);
  EXPECT_EQ(comparison.entries[2].budget, 100);
  EXPECT_EQ(comparison.entries[2].targets, 0.75);
  EXPECT_FALSE(comparison.entries[2].evaluations);
  EXPECT_EQ(comparison.families[0].variables.least, 1);
  EXPECT_EQ(comparison.families[0].variables.most, 3);
}

TEST(Entries, HaveTheSpeedAndAccuracyThatBelongsToThem) {
  Json data = small_comparison();
  data["speed_accuracy"] = {fast("count", 100, "mine", 0.5)};
  const Comparison comparison = comparison_of(found_comparison(data));
  EXPECT_FALSE(comparison.entries[1].evaluations);  // of the other budget
  EXPECT_FALSE(comparison.entries[2].evaluations);  // of the other solver
  const Entry& mine = comparison.entries[3];
  EXPECT_EQ(mine.evaluations, 7.5);
  EXPECT_EQ(mine.solved, 0.5);
  EXPECT_EQ(mine.solved_upper, 0.95);
  EXPECT_FALSE(mine.error);
  EXPECT_TRUE(mine.complete);
}

TEST(Entries, OfManyAreTheFirstAndThoseThatThePageIsAbout) {
  Json data = small_comparison(), family = small_family();
  Json& ratings = family["budgets"][0]["ratings"];
  const Json mine = ratings[1];
  for (int k = 0; k < 40; ++k) {
    Json other = ratings[0];
    other["solver"] = "s" + std::to_string(k);
    ratings.push_back(other);
  }
  ratings.push_back(mine);  // from outside
  data["speed_accuracy"] = {fast("count", 10, "s35", 0.5)};
  const Comparison comparison = comparison_of(found_comparison(data, {family}));
  ASSERT_EQ(comparison.entries.size(), 15U + 2 + 2) << "the other budget has two";
  EXPECT_EQ(comparison.entries[14].place, 15U);
  EXPECT_EQ(comparison.entries[15].solver, "s35");
  EXPECT_EQ(comparison.entries[15].place, 38U);
  EXPECT_EQ(comparison.entries[16].solver, "mine");
  EXPECT_EQ(comparison.entries[16].place, 43U);
  EXPECT_EQ(comparison.entries[16].of, 43U);
}

TEST(Entries, OfAllFamiliesTogetherComeFirstBestFirst) {
  Json data = small_comparison();
  data["speed_accuracy"] = {fast("all", nullptr, "mine", 0.5), fast("all", nullptr, "scan", 0.6)};
  const Comparison comparison = comparison_of(found_comparison(data));
  EXPECT_EQ(comparison.families[0].name, "all");
  EXPECT_EQ(comparison.families[0].problems, 2U);
  ASSERT_EQ(comparison.entries.size(), 6U);
  EXPECT_EQ(comparison.entries[0].solver, "scan");
  EXPECT_EQ(comparison.entries[0].budget, 0);
  EXPECT_FALSE(comparison.entries[0].best);
  EXPECT_EQ(comparison.entries[2].family, 1U);
}

TEST(Curves, BeginAtNothingAndLeaveOutTheMidstOfALevel) {
  const Comparison comparison = comparison_of(found_comparison());
  EXPECT_EQ(Json(comparison.curves.at(0).points).dump(), "[[1.0,0.0],[4.0,0.0],[8.0,0.5]]");
  Json family = small_family();
  Json& first = family["budgets"][0]["first"];
  for (Json& step : first[0]["progress"]) step["share"] = 0.5;
  family["budgets"][0]["paper"] = {first[0]};
  family["budgets"][0]["paper"][0]["solver"] = "fireworks";
  const Comparison other = comparison_of(found_comparison(small_comparison(), {family}));
  EXPECT_EQ(Json(other.curves.at(0).points).dump(), "[[1.0,0.0],[1.0,0.5],[8.0,0.5]]");
  EXPECT_EQ(other.curves.at(1).solver, "fireworks");
}

TEST(Entries, KnowTheKindsOfSolversIfTheDataDo) {
  Json data = small_comparison();
  EXPECT_TRUE(comparison_of(found_comparison(data)).kinds.empty());
  data["solvers"][0]["kind"] = "direct search";
  const Comparison comparison = comparison_of(found_comparison(data));
  EXPECT_EQ(comparison.kinds.size(), 1U);
  EXPECT_EQ(comparison.kinds.begin()->second, "direct search");
}

TEST(Comparison, OfAnotherVersionIsNotRead) {
  Json family = small_family();
  family["budgets"][0]["ratings"][0].erase("returned");
  EXPECT_THROW(comparison_of(found_comparison(small_comparison(), {family})), Json::exception);
}

TEST(Comparison, IsTheLargestOfThoseThatHoldEntries) {
  std::vector<FoundReport> reports(3, found_comparison());
  reports[0].folder = "a";
  reports[1].folder = "b";
  reports[1].data["runs"] = 80;
  reports.push_back(reports[1]);
  reports[3].headline->holds.clear();
  reports[3].data["runs"] = 800;
  EXPECT_EQ(largest_comparison(reports)->folder, "b");
  EXPECT_EQ(largest_comparison({}), nullptr);
}

}  // namespace
}  // namespace ricochet::site
