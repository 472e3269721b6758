#include "src/report/site/paper_machines.h"

#include <gmock/gmock.h>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

PaperMachines four_machines() {
  return {"reproduction",
          {{"A", 0.1, 0.4, 0, 2.0, 12.0, 13.0},
           {"B", 0.1, 0.4, 1, 2.0, 11.4, std::nullopt},
           {"C", 0.9, 0.4, 0, 2.0, 4.0, 3.0},
           {"D", 0.1, 0.1, 0, 1.0, 8.0, 9.0}},
          0.06,
          10,
          5};
}

TEST(PaperMachines, AreReadFromTheReportOfThePapersCases) {
  const Json one = {{"id", "C1"},          {"restitution", 0.1},  {"friction", 0.1},
                    {"disturbance", 0},    {"silent_up_to", 1.5}, {"quiet_up_to", 8.0},
                    {"paper_threshold", 9}};
  const FoundReport report = made_up("reproduction",
                                     {{"cases", {{"C1", one}}},
                                      {"agreement", {{"thresholds", 10}, {"error", 0.06}}},
                                      {"interpretation", {{"fitted", 5}}}},
                                     "mine");
  const auto all = paper_machines({report});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->folder, "mine");
  EXPECT_EQ(all->machines.at(0).quiet_up_to, 8.0);
  EXPECT_EQ(
      agreement_sentence(*all),
      "By the paper's own rule 10 thresholds are 6 % from the paper's (root-mean-square error "
      "in log speed), after fitting 5 parameters to the same thresholds.");
  EXPECT_FALSE(paper_machines({}));
}

TEST(ThresholdEffects, AreFromPairsThatDifferInOneConstant) {
  const auto effects = threshold_effects(four_machines().machines);
  ASSERT_EQ(effects.size(), 3U);
  EXPECT_EQ(effects[0].constant, "restitution");
  EXPECT_DOUBLE_EQ(effects[0].most, 4.0 / 12);
  EXPECT_EQ(effects[0].pairs, 1U);
  EXPECT_DOUBLE_EQ(effects[1].least, 1.5);
  EXPECT_DOUBLE_EQ(effects[2].least, 0.95);
  EXPECT_EQ(
      effects_sentence(four_machines()),
      "The threshold: restitution from 0.1 to 0.9 divides it by 3.0; friction from 0.1 to 0.4 "
      "multiplies it by 1.5; disturbance from 0 to 1 N lowers it by 5.0 %.");
}

TEST(ThresholdEffects, OfBothSignsAreToldWithTheirSigns) {
  PaperMachines machines = four_machines();
  machines.machines.push_back({"E", 0.1, 0.1, 1, 1.0, 8.8, std::nullopt});
  EXPECT_THAT(effects_sentence(machines), HasSubstr("changes it by -5.0 to +10.0 %"));
}

TEST(RegimesChart, HasAColumnForEachMachineAndThePapersThresholds) {
  const report::Chart chart = regimes_chart(four_machines());
  EXPECT_NO_THROW(check(chart));
  EXPECT_THAT(chart.x.categories, testing::ElementsAre("A", "B", "C", "D"));
  ASSERT_EQ(chart.areas.size(), 3U);
  EXPECT_EQ(chart.areas[1].parts.at(2).at(0).between.lower, 2.0);
  EXPECT_EQ(chart.areas[1].parts.at(2).at(0).between.upper, 4.0);
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_EQ(chart.series[0].samples.size(), 3U);  // B has none
  EXPECT_THAT(speed_sentence(four_machines()), HasSubstr("4.0 to 12.0 rad/s (38 to 115 rpm)"));
  EXPECT_EQ(groups_sentence(four_machines()).substr(0, 37),
            "A, B: restitution 0.1, friction 0.4; ");
}

}  // namespace
}  // namespace ricochet::site
