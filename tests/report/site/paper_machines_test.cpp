#include "src/report/site/paper_machines.h"

#include <gmock/gmock.h>

#include "src/report/results.h"
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
          5,
          "",
          {}};
}

TEST(PaperMachines, AreReadFromTheReportOfThePapersCases) {
  report::Results results;
  ricochet::Table cases{"thresholds",
                        {{"case"},
                         {"restitution"},
                         {"friction"},
                         {"disturbance"},
                         {"silent_up_to"},
                         {"quiet_up_to"},
                         {"paper_threshold"}}};
  cases.add("C2", 0.9, 0.1, 0, std::nullopt, 2.0, std::nullopt);
  cases.add("C1", 0.1, 0.1, 0, 1.5, 8.0, 9);
  results.add(cases);
  results.set("compared", 10);
  results.set("error", 0.06);
  results.set("fitted", 5);
  results.set("moves", "All moves it.");
  results.set("from_end_to_end", std::optional<std::string>());
  results.add(report::Chart{.name = "threshold-over-restitution", .title = "", .x = {}, .y = {}});
  const FoundReport report = made_up("reproduction", json_of(results), "mine");
  const auto all = paper_machines({report});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->folder, "mine");
  EXPECT_EQ(all->machines.at(0).quiet_up_to, 8.0);
  EXPECT_EQ(all->machines.at(0).paper_threshold, 9.0);
  EXPECT_FALSE(all->machines.at(1).silent_up_to);
  EXPECT_EQ(effects_sentence(*all), "All moves it.");
  EXPECT_EQ(all->charts.size(), 1U);
  EXPECT_EQ(
      agreement_sentence(*all),
      "By the paper's own rule 10 thresholds are 6 % from the paper's (root-mean-square error "
      "in log speed), after fitting 5 parameters to the same thresholds.");
  EXPECT_FALSE(paper_machines({}));
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
