#include <gmock/gmock.h>

#include "src/report/site/chooser.h"
#include "src/report/site/front.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

Json competing_row(const char* solver, const char* formulation, double evaluations, double share) {
  return {{"family", "top-speed"},      {"largest", true},   {"budget", 1000},
          {"complete", true},           {"solver", solver},  {"formulation", formulation},
          {"evaluations", evaluations}, {"seconds", 1e-3},   {"share", share},
          {"share_lower", share / 2},   {"share_upper", 1.0}};
}

/// A comparison in which a simulation takes 10 µs: of two solvers that are shown a count, of one
/// that solves nothing, of one that needs gradients, and of another family and budget.
FoundReport racing() {
  Json comparison = small_comparison();
  comparison["speed_accuracy"] = {
      competing_row("halving", "count", 10, 1), competing_row("lucky", "penalised-count", 4, 0.5),
      competing_row("lost", "count", 1000, 0),  competing_row("sloped", "surrogate", 3, 1),
      competing_row("other", "count", 3, 1),    competing_row("poor", "count", 3, 1)};
  comparison["speed_accuracy"][4]["family"] = "count";
  comparison["speed_accuracy"][5]["largest"] = false;
  const Json family = {
      {"family", "top-speed"},
      {"problems", {{{"problem", "top-speed-C1"}, {"variables", 1}, {"constraints", 1}}}},
      {"budgets", Json::array()},
      {"break_even_families", {{{"budget", 1000}, {"here", {{{"simulation", 1e-5}}}}}}}};
  FoundReport report = found_comparison(comparison, {small_family(), family});
  report.folder = "race";
  return report;
}

Json simulated(const char* name, const char* control, double seconds, const Json& error) {
  return {{"simulation", name}, {"control", control}, {"reference", error == 0.0},
          {"seconds", seconds}, {"error", error},     {"error_least", error}};
}

FoundReport moving() {
  return made_up(
      "dynamics",
      {{"thresholds",
        {{"family", "top-speed"},
         {"formulations", {"count", "penalised-count"}},
         {"names", {"C1"}},
         {"tolerance", 0.01},
         {"cases",
          {{{"case", "C1"}, {"threshold", 8.0}}, {{"case", "C2"}, {"threshold", nullptr}}}},
         {"simulations",
          {simulated("exact", "", 1e-4, 0.0), simulated("coarse", "step 1e-2", 1e-6, 2.0),
           simulated("slow", "tolerance 1e-9", 1e-2, 1e-9),
           simulated("blind", "step 1", 1e-9, nullptr)}}}}},
      "motion", {"simulations"});
}

TEST(Pairs, AreOfSolversThatAreShownACountAndOfSimulationsThatFindAThreshold) {
  const auto pairs = pairs_of(moving(), racing());
  ASSERT_TRUE(pairs);
  ASSERT_EQ(pairs->solvers.size(), 2U);
  EXPECT_EQ(pairs->solvers[0].solver, "halving");
  EXPECT_NEAR(pairs->solvers[0].own, 1e-3 - 10 * 1e-5, 1e-9);
  EXPECT_EQ(pairs->solvers[1].solver, "lucky");
  ASSERT_EQ(pairs->simulations.size(), 3U);
  EXPECT_EQ(pairs->cases, std::vector<std::string>{"C1"});
  EXPECT_EQ(pairs->folder, "motion");
}

TEST(Pairs, CostAllOfASolverUntilItSucceedsAndErrByBoth) {
  const auto pairs = all_pairs(pairs_of(moving(), racing()).value());
  ASSERT_EQ(pairs.size(), 6U);
  EXPECT_NEAR(pairs[0].seconds, 9e-4 + 10 * 1e-4, 1e-9);  // halving, exact
  EXPECT_DOUBLE_EQ(pairs[0].error, 0.01);
  EXPECT_NEAR(pairs[4].seconds, 2 * (9.6e-4 + 4 * 1e-6), 1e-9);  // lucky, coarse: every other run
  EXPECT_DOUBLE_EQ(pairs[4].error, 2.01);
}

TEST(Pairs, LeadWhereNoOtherIsAsFastAndAsAccurate) {
  const Pairs data = pairs_of(moving(), racing()).value();
  const auto front = leading(all_pairs(data));
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(name_of(data, front[0]), "halving, coarse step 1e-2");
  EXPECT_EQ(name_of(data, front[1]), "halving, exact");
  EXPECT_EQ(finding_of(data),
            "Of 6 pairs the most accurate is halving, exact (within 0.01 rad/s after 1.9 ms); the "
            "fastest is halving, coarse step 1e-2 (within 2 rad/s after 0.91 ms).");
}

TEST(Pairs, ErrByNoMoreThanTheFastestThreshold) {
  FoundReport wild = moving();
  wild.data["thresholds"]["simulations"][1]["error"] = 100.0;
  const Pairs data = pairs_of(wild, racing()).value();
  EXPECT_EQ(data.range, 8);
  EXPECT_EQ(all_pairs(data)[1].error, 8);  // halving, coarse
  EXPECT_EQ(within_range(data).size(), 4U);
  EXPECT_THAT(finding_of(data), HasSubstr("halving, exact (within 0.01 rad/s after 1.9 ms)"));
  EXPECT_THAT(finding_of(data), testing::Not(HasSubstr("coarse")));
}

TEST(Pairs, AreNothingWithoutSolversOrSimulations) {
  EXPECT_FALSE(front_of({racing()}).pairs);
  EXPECT_FALSE(front_of({moving()}).pairs);
  EXPECT_TRUE(front_of({racing(), moving()}).pairs);
  EXPECT_FALSE(pairs_of(moving(), found_comparison()));
}

TEST(Pairs, OfDataOfAnotherVersionAreNone) {
  FoundReport old = moving();
  old.data["thresholds"].erase("family");
  const Front front = front_of({racing(), old});
  EXPECT_FALSE(front.pairs);
  EXPECT_THAT(front.cards.at(1).finding, HasSubstr("another version"));
  EXPECT_THAT(front.unread, testing::ElementsAre(testing::Pair("motion", HasSubstr("family"))));
}

TEST(Pairs, AreOfSolversOfWhichNothingIsMissing) {
  for (const char* number : {"seconds", "evaluations", "share_lower", "share_upper"}) {
    FoundReport partly = racing();
    for (Json& one : partly.data["speed_accuracy"]) {
      if (one["solver"] == "halving") one[number] = nullptr;
    }
    const Front front = front_of({partly, moving()});
    ASSERT_TRUE(front.pairs) << number;
    ASSERT_EQ(front.pairs->solvers.size(), 1U) << number;
    EXPECT_EQ(front.pairs->solvers[0].solver, "lucky");
  }
}

TEST(Pairs, StandStillWithEverySimulation) {
  const report::Chart chart = pairs_chart(pairs_of(moving(), racing()).value());
  ASSERT_EQ(chart.series.size(), 4U);  // the front, and three simulations
  EXPECT_EQ(chart.series[0].samples.size(), 2U);
  EXPECT_EQ(chart.series[1].samples[0].name, "halving, exact");
  EXPECT_EQ(chart.series[3].samples[0].name, "");
  EXPECT_EQ(chart.title, "The most accurate pair is halving, exact: 0.01 rad/s in 1.9 ms");
  EXPECT_THAT(chart.description, HasSubstr("Of 6 pairs"));
}

}  // namespace
}  // namespace ricochet::site
