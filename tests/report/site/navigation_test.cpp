#include "src/report/site/navigation.h"

#include <gmock/gmock.h>

#include <iterator>

#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<FoundReport> two_reports() {
  return {made_up("comparison", Json::object(), "comparison", {"count", "top-speed"}),
          made_up("verification", Json::object(), "small & fine")};
}

std::string links_at(const std::string& here) {
  return navigation(
      places_of(two_reports(), {{"Data", "Cite", "cite"}, {"Solvers", "Beside", "beside"}}), here);
}

class LinkPages : public TemporaryFolder {};

TEST(Navigation, HasAWordForEachGroupThatLeadsToItsFirstPlace) {
  const std::string links = links_at("comparison");
  EXPECT_THAT(links, HasSubstr("<a href=\"../index.html\">ricochet</a>"));
  EXPECT_THAT(links, HasSubstr("<a href=\"../small &amp; fine/index.html\">Simulation</a>"));
  EXPECT_THAT(links, HasSubstr("<a href=\"../cite/index.html\">Data</a>"));
  EXPECT_THAT(links, Not(HasSubstr("Machine")));
}

TEST(Navigation, ListsThePlacesOfTheOwnGroupAndMarksTheOwn) {
  const std::string links = links_at("comparison");
  EXPECT_THAT(links, HasSubstr("<a href=\"../comparison/index.html\" aria-current=\"page\">"));
  EXPECT_THAT(links, HasSubstr("<a href=\"../beside/index.html\">Beside</a>"));
  EXPECT_THAT(links, Not(HasSubstr("Proof of the impacts: small")));
  EXPECT_THAT(links, HasSubstr("<a href=\"../comparison/count/index.html\">count</a>"));
  EXPECT_THAT(links, Not(HasSubstr("crumbs")));
}

TEST(Navigation, OfAPageOfAReportLeadsBackToIt) {
  const std::string links = links_at("comparison/count");
  EXPECT_THAT(links, HasSubstr("<a href=\"../../comparison/index.html\">All solvers</a> › count"));
  EXPECT_THAT(links, HasSubstr("<a href=\"../../comparison/top-speed/index.html\">"));
  EXPECT_THAT(links, HasSubstr("count/index.html\" aria-current=\"page\""));
}

TEST(Navigation, OfTheFrontPageHasNoPagesOfReports) {
  const std::string links = links_at("");
  EXPECT_THAT(links, HasSubstr("<a href=\"index.html\" aria-current=\"page\">"));
  EXPECT_THAT(links, Not(HasSubstr("top-speed")));
}

TEST_F(LinkPages, PutsTheLinksWhereThePageHasRoomAndDoesSoAgain) {
  const auto page = folder_ / "comparison" / "index.html";
  keep(folder_, "comparison", Json::object());
  std::ofstream(page) << "a<!-- navigation -->old<!-- /navigation -->b";
  const std::vector<Place> places = places_of(two_reports(), {});
  for (int times = 0; times < 2; ++times) link_pages(folder_, places);
  std::ifstream stream(page);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(text,
            "a<!-- navigation -->\n" + navigation(places, "comparison") + "<!-- /navigation -->b");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "small & fine"));
}

}  // namespace
}  // namespace ricochet::site
