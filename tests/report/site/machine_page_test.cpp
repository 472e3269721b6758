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

FoundReport simulators() {
  report::Results results;
  results.set("walls", "Soft walls agree seldom.");
  results.set("planar", "The second direction changes none.");
  ricochet::Table walls{"walls", {{"stiffness"}, {"share"}, {"compared"}}};
  walls.add("1e10", 0.2916, 72);
  results.add(std::move(walls));
  FoundReport report = made_up("simulators", json_of(results), "simulators");
  report.results = std::move(results);
  return report;
}

std::string page_of(const std::vector<FoundReport>& reports) {
  const auto [files, failures] = machine_page(site_results(reports));
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
  EXPECT_THAT(
      page_of({simulators()}),
      AllOf(HasSubstr("If walls give, yes. Soft walls agree seldom."),
            HasSubstr("| 1e10 | 29 | 72 |"), HasSubstr("The second direction changes none."),
            Not(HasSubstr("## The paper's"))));
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
  const report::Results site =
      site_results(found_reports(std::filesystem::path(RICOCHET_SOURCE) / "reports/reference"));
  const ricochet::Table* walls = site.table("simulators-walls");
  ASSERT_TRUE(walls);
  ASSERT_GT(walls->rows.size(), 1U);
  EXPECT_LT((*walls)[0].number("share"), 0.5);
  EXPECT_GT((*walls)[walls->rows.size() - 1].number("share"), 0.9);
}

}  // namespace
}  // namespace ricochet::site
