#include "src/report/site/machine_page.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Three machines; of B the paper has no threshold, C is loud at once.
ricochet::Table three_machines() {
  ricochet::Table table{"thresholds",
                        {{"case"},
                         {"restitution"},
                         {"friction"},
                         {"disturbance"},
                         {"silent_up_to"},
                         {"quiet_up_to"},
                         {"paper_threshold"},
                         {"quiet_error"}}};
  table.add("A", 0.1, 0.4, 0, 2.0, 12.0, 13.0, 12.0 / 13 - 1);
  table.add("B", 0.1, 0.1, 1, 1.0, 4.0, std::nullopt, std::nullopt);
  table.add("C", 0.9, 0.1, 0, std::nullopt, std::nullopt, 2.0, std::nullopt);
  return table;
}

FoundReport reproduction() {
  report::Results results;
  results.set("moves", "Much moves it.");
  results.add(three_machines());
  FoundReport report = made_up("reproduction", json_of(results), "reproduction");
  report.results = std::move(results);
  return report;
}

Json dynamics_data() {
  return {{"planar", {{"most_wrong", 0.0}, {"largest_tangent", 1.5}}},
          {"fidelity",
           {{"stiffnesses",
             {{{"stiffness", "1e10"}, {"compared", 72}, {"share", 0.2916}},
              {{"stiffness", "1e18"}, {"compared", 72}, {"share", 0.9861}}}}}}};
}

std::string page_of(const std::vector<FoundReport>& reports) {
  const auto [files, failures] = machine_page(site_results(reports), reports);
  EXPECT_TRUE(failures.empty());
  return files.at("summary.md");
}

TEST(MachinePage, HasTheSpeedsOfTheLongRun) {
  const std::string page = page_of({reproduction()});
  EXPECT_THAT(page, AllOf(HasSubstr("The paper's 3 machines stay quiet up to 4.0 to 12.0 rad/s (38 "
                                    "to 115 rpm)"),
                          HasSubstr("| A | 0.1 | 0.4 | 0 | 2.00 | 12.00 | 13 | -8 |"),
                          HasSubstr("Much moves it."), HasSubstr("(regimes-of-the-machines.svg)"),
                          Not(HasSubstr("Does the level of the model matter?"))));
}

TEST(MachinePage, SaysHowTheLevelsOfTheModelDiffer) {
  const std::string page = page_of({made_up("dynamics", dynamics_data(), "dynamics")});
  EXPECT_THAT(page,
              AllOf(HasSubstr("compliant walls of 1e10 N/m^1.5 agree with hard ones in 29 % of "
                              "72 counts, those of 1e18 N/m^1.5 in 99 % of 72 counts."),
                    HasSubstr("changes none of the counts in the paper's cases, up to a "
                              "lateral yarn pull of 1.5 times"),
                    HasSubstr("| 1e10 | 29 | 72 |"), Not(HasSubstr("## The paper's"))));
  EXPECT_FALSE(model_levels({made_up("dynamics", {{"planar", 1}}, "dynamics")}));
}

TEST(MachinePage, OfNoReportsSaysHowToDescribeAMachine) {
  EXPECT_THAT(page_of({}), AllOf(HasSubstr("./ricochet machine new"), HasSubstr("Top speed in the"),
                                 Not(HasSubstr("What moves"))));
}

TEST(RegimesChart, HasAColumnForEachMachineAndThePapersThresholds) {
  const report::Chart chart = regimes_chart(three_machines());
  EXPECT_NO_THROW(check(chart));
  EXPECT_THAT(chart.x.categories, testing::ElementsAre("A", "B", "C"));
  ASSERT_EQ(chart.areas.size(), 3U);
  ASSERT_EQ(chart.areas[1].parts.size(), 2U) << "C is quiet nowhere";
  EXPECT_EQ(chart.areas[1].parts[1][0].between.lower, 1.0);
  EXPECT_EQ(chart.areas[1].parts[1][0].between.upper, 4.0);
  EXPECT_EQ(chart.areas[2].parts.at(2).at(0).between.lower, 0.0);
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_EQ(chart.series[0].samples.size(), 2U) << "B has none";
}

/// What the page says of stiff and soft walls holds in the committed reports.
TEST(MachinePage, ReadsTheReference) {
  const auto levels =
      model_levels(found_reports(std::filesystem::path(RICOCHET_SOURCE) / "reports/reference"));
  ASSERT_TRUE(levels);
  ASSERT_GT(levels->walls.size(), 1U);
  EXPECT_LT(levels->walls.front().share.value(), 0.5);
  EXPECT_GT(levels->walls.back().share.value(), 0.9);
}

}  // namespace
}  // namespace ricochet::site
