#include <gmock/gmock.h>

#include "src/report/site/front.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;

TEST(CitePage, HasVersionDigestCommandsAndBibTeX) {
  Json data = small_comparison();
  data["digest"] = "0123abcd";
  data["suite"] = 3;
  data["made"] = {{"version", "9.8.7"}, {"compiler", "GCC 1"}, {"date", "2031-02-03"}};
  data["solvers"] = {{{"name", "scan"}, {"version", "ricochet 9"}, {"outside", false}},
                     {{"name", "a"}, {"version", "Lib 1"}, {"outside", false}},
                     {{"name", "b"}, {"version", "Lib 1"}, {"outside", false}}};
  const FoundReport comparison = found_comparison(data);
  const OwnPage own = cite_page({comparison}, &comparison);
  EXPECT_THAT(own.page.sections.at(0).code.at(0), HasSubstr("year    = {2031}"));
  EXPECT_THAT(own.page.sections[0].code[0], HasSubstr("Yao, Lingling"));
  EXPECT_THAT(own.page.sections.at(1).paragraphs.at(1), HasSubstr("0123abcd"));
  EXPECT_THAT(own.page.sections[1].code.at(0), HasSubstr("./ricochet run compare --out"));
  const auto& tables = own.page.sections.at(2).tables;
  EXPECT_EQ(tables.at(0).rows.at(0).at(2).text, "9.8.7");
  ASSERT_EQ(tables.at(1).rows.size(), 2U);
  EXPECT_EQ(tables[1].rows[1][1].text, "a, b");
  EXPECT_THAT(own.page.sections.at(3).code.at(0), HasSubstr("cff-version"));
}

TEST(CitePage, WithoutAComparisonLeavesItsRunsOut) {
  EXPECT_TRUE(cite_page({}, nullptr).page.sections.at(1).code.empty());
}

}  // namespace
}  // namespace ricochet::site
