#include "src/site/answers.h"

#include <gtest/gtest.h>

#include "tests/site/made_up_reports.h"

namespace ricochet::site {
namespace {

Json a_case(double restitution, const Json& threshold, const Json& published) {
  return {{"restitution", restitution},
          {"friction", 0.1},
          {"threshold", threshold},
          {"paper_threshold", published}};
}

TEST(SpeedAnswer, RangesOverTheDisturbancesOfAMachine) {
  const Json data = {{"cases",
                      {{"C1", a_case(0.1, 8, 9)},
                       {"C2", a_case(0.9, 2, nullptr)},
                       {"C5", a_case(0.1, 7, 8.5)},
                       {"C9", a_case(0.1, nullptr, 7)}}}};
  const Json answer = speed_answer({made_up("reproduction", data, "first")});
  EXPECT_EQ(answer["folder"], "first");
  EXPECT_EQ(answer["speed"]["least"], 2);
  EXPECT_EQ(answer["speed"]["most"], 8);
  ASSERT_EQ(answer["rows"].size(), 2);
  const Json& damped = answer["rows"][0];
  EXPECT_EQ(damped["cases"], "C1, C5, C9");
  EXPECT_EQ(damped["speed"], (Json{{"least", 7.0}, {"most", 8.0}, {"one", false}}));
  EXPECT_EQ(damped["published"], (Json{{"least", 7.0}, {"most", 9.0}, {"one", false}}));
  EXPECT_NEAR(damped["turns"]["most"].get<double>(), 76.394, 1e-3);  // 8 rad/s a minute
  EXPECT_TRUE(answer["rows"][1]["published"].is_null());
  EXPECT_EQ(answer["rows"][1]["speed"]["one"], true);
}

TEST(SpeedAnswer, IsNothingWithoutAReproduction) {
  EXPECT_TRUE(speed_answer({}).is_null());
  EXPECT_TRUE(solver_answer({}).is_null());
}

TEST(SolverAnswer, PlacesSolversFromOutsideWithTheLargestBudget) {
  const Json answer = solver_answer({made_up("contest", small_contest(), "contest")});
  ASSERT_EQ(answer["leaders"].size(), 1);
  EXPECT_EQ(answer["leaders"][0]["lower"], 0.33333);
  ASSERT_EQ(answer["places"].size(), 1);
  EXPECT_EQ(answer["places"][0]["solver"], "mine");
  EXPECT_EQ(answer["places"][0]["budget"], 100);
  EXPECT_EQ(answer["places"][0]["place"], 2);
  EXPECT_EQ(answer["places"][0]["of"], 2);
}

TEST(SolverAnswer, LeadsToWhoSolvesWhat) {
  Json contest = small_contest();
  contest["families"] = {{{"family", "count"}}, {{"family", "hs"}}};
  for (int k = 0; k < 20; ++k) {
    contest["map"].push_back({{"solver", "s" + std::to_string(k)}, {"shares", {0.5, nullptr}}});
  }
  contest["pages"] = {"count", "hs", "failure-atlas"};
  const Json answer = solver_answer({made_up("contest", contest, "contest")});
  EXPECT_EQ(answer["map"]["solvers"], 20);
  ASSERT_EQ(answer["map"]["rows"].size(), 12);
  EXPECT_EQ(answer["map"]["rows"][11]["solver"], "s11");
  EXPECT_EQ(answer["map"]["rows"][0]["cells"],
            (Json{{{"family", "count"}, {"share", 0.5}}, {{"family", "hs"}, {"share", nullptr}}}));
  EXPECT_TRUE(answer["failure_atlas"].get<bool>());
  EXPECT_FALSE(answer["across_machines"].get<bool>());
}

TEST(SolverAnswer, IsThatOfTheContestOfMostRuns) {
  Json large = small_contest();
  large["runs"] = 80;
  const Json answer =
      solver_answer({made_up("contest", small_contest(), "a"), made_up("contest", large, "b"),
                     made_up("contest", small_contest(), "c")});
  EXPECT_EQ(answer["folder"], "b");
}

}  // namespace
}  // namespace ricochet::site
