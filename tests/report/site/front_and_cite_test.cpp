#include <gmock/gmock.h>

#include "src/report/site/front.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(CitePage, HasVersionDigestCommandsAndBibTeX) {
  FoundReport comparison = found_comparison();
  comparison.made.version = "9.8.7";
  comparison.made.date = "2031-02-03";
  const std::string page = cite_page(site_results({comparison})).files.at("summary.md");
  EXPECT_THAT(page, AllOf(HasSubstr("year    = {2031}"), HasSubstr("Yao, Lingling"),
                          HasSubstr("0123abcd"), HasSubstr("./ricochet run compare --out"),
                          HasSubstr("9.8.7"), HasSubstr("cff-version")));
}

TEST(CitePage, WithoutAComparisonLeavesItsRunsOut) {
  EXPECT_THAT(cite_page(site_results({})).files.at("summary.md"),
              AllOf(Not(HasSubstr("How do I repeat it?")), HasSubstr("How do I cite it?")));
}

TEST(FrontPage, ShowsWhatReportsSayByTheirNames) {
  const OwnFiles front = front_page(site_results({found_comparison()}));
  const std::string& page = front.files.at("summary.md");
  EXPECT_THAT(page, AllOf(HasSubstr("Found: all."), HasSubstr("| count | 100 | scan, count | 50 |"),
                          HasSubstr("(comparison/summary.md)"),
                          HasSubstr("Not computed here: The paper's cases")));
  EXPECT_THAT(front.files.at("index.html"), HasSubstr("<svg"));
}

TEST(FrontPage, OfNoReportsSaysHowToMakeThem) {
  const std::string page = front_page(site_results({})).files.at("summary.md");
  EXPECT_THAT(page, AllOf(HasSubstr("./ricochet reproduce"), HasSubstr("./ricochet compare"),
                          Not(HasSubstr("Which solver, when?\n\n|"))));
}

TEST(FrontPage, LeavesOutWhatTheDataOfAnotherVersionLack) {
  FoundReport older = found_comparison();
  ricochet::Table leaders{"leaders", {{"family"}, {"budget"}}};
  leaders.add("count", 100);
  older.results->tables = {leaders};
  EXPECT_THAT(front_page(site_results({older})).files.at("summary.md"),
              AllOf(HasSubstr("Found: all."), HasSubstr("| count | 100 | ")));
}

TEST(FrontPage, TakesTheFirstReportOfAKind) {
  FoundReport second = found_comparison();
  second.folder = "other";
  second.results->values.front().second = std::string("Found: nothing.");
  const std::string page =
      front_page(site_results({found_comparison(), second})).files.at("summary.md");
  EXPECT_THAT(page, AllOf(HasSubstr("Found: all."), HasSubstr("(other/summary.md)")));
}

}  // namespace
}  // namespace ricochet::site
