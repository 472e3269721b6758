#include "src/report/site/site.h"

#include <gmock/gmock.h>

#include <iterator>

#include "src/report/text.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string page_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Json data_of(const char* report) {
  return report::data_in(
      page_text(fs::path(RICOCHET_SOURCE) / "reports/reference" / report / "data.json"));
}

Json verification_data() {
  return data_of("verification");
}

class Site : public TemporaryFolder {};

TEST_F(Site, IsAFolderCalledReportsOrOneWithAFrontPage) {
  EXPECT_TRUE(is_site(folder_ / "reports"));
  EXPECT_TRUE(is_site(folder_ / "reports/"));
  EXPECT_FALSE(is_site(folder_ / "mine"));
  keep(folder_, "mine", {{"report", "surrogate"}});
  EXPECT_FALSE(is_site(folder_ / "mine"));
  keep(folder_, "mine", {{"report", "site"}});
  EXPECT_TRUE(is_site(folder_ / "mine"));
}

TEST_F(Site, IsWrittenAboveAReportOnlyWhereThereIsToBeOne) {
  for (const char* above : {"mine", "reports"}) {
    keep(folder_ / above, "verification", verification_data());
    write_site_above(folder_ / above / "verification", {});
  }
  EXPECT_FALSE(fs::exists(folder_ / "mine" / "index.html"));
  const std::string page = page_text(folder_ / "reports" / "index.html");
  EXPECT_THAT(page, HasSubstr("No count called certain is wrong."));
  EXPECT_THAT(page, HasSubstr("./ricochet reproduce"));
}

TEST_F(Site, IsWholeWithWhatTheReferenceHasWhichSaysSo) {
  const fs::path site = folder_ / "reports", reference = folder_ / "reference";
  Json surrogate = data_of("surrogate");
  surrogate["made"]["date"] = "2031-02-03";
  surrogate["pages"] = {"inner"};
  keep(reference, "surrogate", surrogate);
  Json inner = verification_data();
  inner.erase("made");
  keep(reference / "surrogate", "inner", inner);
  keep(reference, "verification", verification_data());
  keep(reference, "fireworks", data_of("fireworks"));
  keep(site, "mine", verification_data());
  fs::create_directories(site / "fireworks");
  std::ofstream(site / "fireworks" / "notes.txt") << "mine";
  write_site_above(site / "mine", reference);

  constexpr const char* mark =
      "Of the committed reference, computed on 2031-02-03: this machine has not computed it.";
  EXPECT_THAT(page_text(site / "surrogate/summary.md"), HasSubstr(mark));
  EXPECT_THAT(page_text(site / "surrogate/index.html"), HasSubstr(mark));
  EXPECT_THAT(page_text(site / "surrogate/inner/summary.md"),
              HasSubstr("Of the committed reference"));
  const std::string front = page_text(site / "summary.md");
  EXPECT_THAT(front,
              HasSubstr("Computed on this machine: Proof of the impacts: mine. All else is of "
                        "the committed reference, computed on 2031-02-03."));
  EXPECT_THAT(front, HasSubstr("| 2031-02-03 of the reference |"));
  EXPECT_FALSE(fs::exists(site / "verification")) << "this machine has one";
  EXPECT_FALSE(fs::exists(site / "fireworks/index.html")) << "somebody has something there";

  // What is drawn stays until the reference changes.
  std::ofstream(site / "surrogate/index.html") << "drawn";
  write_site(site, reference);
  EXPECT_EQ(page_text(site / "surrogate/index.html"), "drawn");
  surrogate["made"]["date"] = "2032-02-03";
  keep(reference, "surrogate", surrogate);
  write_site(site, reference);
  EXPECT_THAT(page_text(site / "surrogate/index.html"), HasSubstr("computed on 2032-02-03"));

  // This machine's own takes the place of the reference's.
  keep(site, "own", data_of("surrogate"));
  write_site(site, reference);
  EXPECT_THAT(page_text(site / "summary.md"), Not(HasSubstr("of the committed reference")));
}

TEST_F(Site, WithoutAReferenceSaysThatItIsNotWhole) {
  keep(folder_ / "reports", "verification", verification_data());
  write_site(folder_ / "reports", {});
  EXPECT_THAT(page_text(folder_ / "reports/index.html"),
              HasSubstr("The pages have only what this machine has computed"));
}

TEST_F(Site, IsDrawnAgainWithAllItsReportsAndTheirLinks) {
  keep(folder_ / "from", "verification", verification_data());
  ASSERT_TRUE(redraw_site(folder_ / "from", folder_ / "to"));
  EXPECT_THAT(page_text(folder_ / "to/verification/index.html"),
              HasSubstr("<a href=\"../index.html\">ricochet</a>"));
  EXPECT_FALSE(fs::exists(folder_ / "from/index.html"));
  const std::string first = page_text(folder_ / "to/index.html");
  ASSERT_TRUE(redraw_site(folder_ / "to", folder_ / "again"));
  EXPECT_EQ(page_text(folder_ / "again/index.html"), first);
}

TEST_F(Site, HasTheLivePageWithLinksToItsReports) {
  keep(folder_ / "from", "verification", verification_data());
  ASSERT_TRUE(redraw_site(folder_ / "from", folder_ / "to"));
  const std::string page = page_text(folder_ / "to/live/index.html");
  EXPECT_THAT(page, HasSubstr("<a href=\"../verification/index.html\">"));
  EXPECT_THAT(page, HasSubstr("<a href=\"../live/index.html\" aria-current=\"page\">"));
  EXPECT_THAT(page, HasSubstr("<h1>A live machine</h1>"));
  EXPECT_LT(page.size(), 450'000U);
  EXPECT_THAT(page_text(folder_ / "to/index.html"), HasSubstr("<a href=\"live/index.html\">"));
}

TEST_F(Site, IsNotWhatIsOneReportOrNone) {
  keep(folder_, "verification", verification_data());
  EXPECT_FALSE(redraw_site(folder_ / "verification", folder_ / "to"));
  EXPECT_FALSE(redraw_site(folder_ / "nowhere", folder_ / "to"));
  EXPECT_FALSE(fs::exists(folder_ / "to"));
}

TEST_F(Site, ShowsTextsOfItsReportsAsTexts) {
  report::Results results = *found_comparison().results;
  results.values.front().second = std::string("<i>");
  results.tables.front().rows[0][2] = std::string("</script><b>");
  Json data = json_of(results);
  data["report"] = "comparison";
  keep(folder_, "comparison", data);
  write_site(folder_, {});
  const std::string page = page_text(folder_ / "index.html");
  EXPECT_THAT(page, HasSubstr("&lt;i&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
  EXPECT_THAT(page, Not(HasSubstr("<i>")));
}

TEST_F(Site, ShowsThatDataAreOfAnotherVersion) {
  keep(folder_ / "from", "verification", {{"report", "verification"}});
  const auto failures = redraw_site(folder_ / "from", folder_ / "to");
  ASSERT_TRUE(failures);
  EXPECT_THAT(*failures,
              ElementsAre(StartsWith((folder_ / "from/verification/data.json").string() + ": ")));
  EXPECT_THAT(page_text(folder_ / "to/index.html"), HasSubstr("another version"));
}

TEST_F(Site, LinksNoPageOutsideOfIt) {
  keep(folder_ / "from", "verification",
       {{"report", "verification"}, {"pages", {"../../../outside"}}});
  const std::string other = "<!-- navigation -->kept<!-- /navigation -->";
  fs::create_directories(folder_ / "outside");
  std::ofstream(folder_ / "outside/index.html") << other;
  fs::create_directories(folder_ / "to" / "site");
  ASSERT_TRUE(redraw_site(folder_ / "from", folder_ / "to" / "site"));
  EXPECT_EQ(page_text(folder_ / "outside/index.html"), other);
}

}  // namespace
}  // namespace ricochet::site
