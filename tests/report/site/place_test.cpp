#include <gmock/gmock.h>

#include "src/report/site/navigation.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

std::vector<std::string> folders_of(const std::vector<Place>& places) {
  std::vector<std::string> folders;
  for (const Place& place : places) folders.push_back(place.folder);
  return folders;
}

TEST(Places, AreInTheOrderOfTheWordsWithTheSitesOwnFirst) {
  const std::vector<FoundReport> reports = {
      made_up("verification", Json::object(), "verification"),
      made_up("comparison", Json::object(), "mine"),
      made_up("reproduction", Json::object(), "reproduction")};
  EXPECT_THAT(
      folders_of(places_of(reports, {{"Data", "Cite", "cite"}, {"Machine", "It", "machine"}})),
      testing::ElementsAre("machine", "mine", "verification", "reproduction", "cite"));
}

TEST(Places, HaveThosePagesOfReportsThatNameAGroup) {
  FoundReport report = made_up("comparison", Json::object(), "comparison", {"count", "failures"});
  report.pages[1].headline = Headline{};
  report.pages[1].headline->group = "Robustness";
  report.pages[1].headline->label = "Noise";
  const std::vector<Place> places = places_of({report}, {});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[1].folder, "comparison/failures");
  EXPECT_EQ(places[1].label, "Noise");
}

TEST(Places, OfEveryKindOfReportHaveAWordOfTheNavigation) {
  for (const report::ReportKind& kind : report::report_kinds()) {
    EXPECT_EQ(places_of({made_up(kind.name, Json::object(), "x")}, {}).size(), 1U) << kind.name;
  }
}

}  // namespace
}  // namespace ricochet::site
