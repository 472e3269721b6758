#include "src/site/pairs.h"

#include <gmock/gmock.h>

#include "src/site/front_charts.h"
#include "tests/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

Json competing_row(const char* solver, const char* form, double evaluations, double share) {
  return {{"family", "top-speed"}, {"largest", true}, {"budget", 1000},
          {"solver", solver},      {"form", form},    {"evaluations", evaluations},
          {"seconds", 1e-3},       {"share", share},  {"share_lower", share / 2},
          {"share_upper", 1.0}};
}

/// A contest in which a simulation takes 10 µs: of two solvers that are shown a count, of one that
/// solves nothing, of one that needs gradients, and of another family and budget.
FoundReport racing() {
  Json contest = small_contest();
  contest["speed_accuracy"] = {
      competing_row("halving", "count", 10, 1), competing_row("lucky", "penalised-count", 4, 0.5),
      competing_row("lost", "count", 1000, 0),  competing_row("sloped", "surrogate", 3, 1),
      competing_row("other", "count", 3, 1),    competing_row("poor", "count", 3, 1)};
  contest["speed_accuracy"][4]["family"] = "count";
  contest["speed_accuracy"][5]["largest"] = false;
  contest["groups"].push_back(
      {{"family", "top-speed"},
       {"questions", {{{"question", "top-speed-C1"}, {"variables", 1}, {"constraints", 1}}}},
       {"budgets", Json::array()},
       {"break_even_families", {{{"budget", 1000}, {"here", {{{"simulation", 1e-5}}}}}}}});
  return made_up("contest", contest, "race");
}

Json simulated(const char* name, const char* control, double seconds, const Json& error) {
  return {{"simulation", name}, {"control", control}, {"reference", error == 0.0},
          {"seconds", seconds}, {"error", error},     {"error_least", error}};
}

FoundReport moving() {
  return made_up(
      "dynamics",
      {{"thresholds",
        {{"cases", {{{"case", "C1"}}}},
         {"tolerance", 0.01},
         {"simulations",
          {simulated("exact", "", 1e-4, 0.0), simulated("coarse", "step 1e-2", 1e-6, 2.0),
           simulated("slow", "tolerance 1e-9", 1e-2, 1e-9),
           simulated("blind", "step 1", 1e-9, nullptr)}}}}},
      "motion");
}

TEST(Pairs, AreOfSolversThatAreShownACountAndOfSimulationsThatFindAThreshold) {
  const Json data = pairs_data({racing(), moving()});
  ASSERT_EQ(data["solvers"].size(), 2U);
  EXPECT_EQ(data["solvers"][0]["solver"], "halving");
  EXPECT_NEAR(data["solvers"][0]["own"].get<double>(), 1e-3 - 10 * 1e-5, 1e-9);
  EXPECT_EQ(data["solvers"][1]["solver"], "lucky");
  ASSERT_EQ(data["simulations"].size(), 3U);
  EXPECT_EQ(data["cases"], Json::array({"C1"}));
  EXPECT_EQ(data["folder"], "motion");
}

TEST(Pairs, CostAllOfASolverUntilItSucceedsAndErrByBoth) {
  const auto pairs = pairs_of(pairs_data({racing(), moving()}));
  ASSERT_EQ(pairs.size(), 6U);
  EXPECT_NEAR(pairs[0].seconds, 9e-4 + 10 * 1e-4, 1e-9);  // halving, exact
  EXPECT_DOUBLE_EQ(pairs[0].error, 0.01);
  EXPECT_NEAR(pairs[4].seconds, 2 * (9.6e-4 + 4 * 1e-6), 1e-9);  // lucky, coarse: every other run
  EXPECT_DOUBLE_EQ(pairs[4].error, 2.01);
}

TEST(Pairs, LeadWhereNoOtherIsAsFastAndAsAccurate) {
  const Json data = pairs_data({racing(), moving()});
  const auto front = front_of_pairs(pairs_of(data));
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(name_of_pair(data, front[0]), "halving, coarse step 1e-2");
  EXPECT_EQ(name_of_pair(data, front[1]), "halving, exact");
  EXPECT_EQ(pairs_finding(data),
            "Of 6 pairs the most accurate is halving, exact (within 0.01 rad/s after 1.9 ms); the "
            "fastest is halving, coarse step 1e-2 (within 2 rad/s after 0.91 ms).");
}

TEST(Pairs, AreNothingWithoutBothReports) {
  EXPECT_TRUE(pairs_data({racing()}).is_null());
  EXPECT_TRUE(pairs_data({moving()}).is_null());
  EXPECT_TRUE(pairs_data({made_up("contest", small_contest(), "a"), moving()}).is_null());
  EXPECT_TRUE(pairs_data({racing(), made_up("dynamics", Json::object(), "old")}).is_null());
}

TEST(Pairs, StandStillWithEverySimulation) {
  const Json data = {
      {"contest", nullptr}, {"motion", nullptr}, {"pairs", pairs_data({racing(), moving()})}};
  const auto charts = front_charts(data);
  ASSERT_EQ(charts.size(), 1U);
  ASSERT_EQ(charts[0].series.size(), 4U);  // the front, and three simulations
  EXPECT_EQ(charts[0].series[0].samples.size(), 2U);
  EXPECT_EQ(charts[0].series[1].samples[0].name, "halving, exact");
  EXPECT_EQ(charts[0].series[3].samples[0].name, "");
  EXPECT_EQ(charts[0].title, "The most accurate pair is halving, exact: 0.01 rad/s in 1.9 ms");
  EXPECT_THAT(charts[0].description, HasSubstr("Of 6 pairs"));
}

}  // namespace
}  // namespace ricochet::site
