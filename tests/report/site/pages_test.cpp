#include "src/report/site/front.h"
#include "src/report/site/machine_page.h"
#include "src/report/site/navigation.h"
#include "tests/report/site/made_up_reports.h"

/// The site's own pages, and the navigation of all.
namespace ricochet::site {
namespace {

std::vector<std::string> folders_of(const std::vector<Place>& places) {
  std::vector<std::string> folders;
  for (const Place& place : places) folders.push_back(place.folder);
  return folders;
}

TEST(Places, AreInTheOrderOfTheWordsWithTheSitesOwnFirst) {
  const std::vector<FoundReport> reports = {made_up("verification", {}, "verification"),
                                            made_up("comparison", {}, "mine"),
                                            made_up("reproduction", {}, "reproduction")};
  EXPECT_THAT(
      folders_of(places_of(reports, {{"Data", "Cite", "cite"}, {"Machine", "It", "machine"}})),
      ElementsAre("machine", "mine", "verification", "reproduction", "cite"));
}

TEST(Places, HaveThosePagesOfReportsThatNameAGroup) {
  FoundReport report = made_up("comparison", {}, "comparison", {"count", "failures"});
  report.pages[1].headline = Headline{"", "", "", "Robustness", "Noise"};
  const std::vector<Place> places = places_of({report}, {});
  EXPECT_THAT(folders_of(places), ElementsAre("comparison", "comparison/failures"));
  EXPECT_EQ(places.at(1).label, "Noise");
}

TEST(Places, OfEveryKindOfReportHaveAWordOfTheNavigation) {
  for (const report::ReportKind& kind : report::report_kinds()) {
    EXPECT_EQ(places_of({made_up(kind.name, {}, "x")}, {}).size(), 1U) << kind.name;
  }
}

std::vector<FoundReport> two_reports() {
  return {made_up("comparison", {}, "comparison", {"count", "top-speed"}),
          made_up("verification", {}, "small & fine")};
}

std::string links_at(const std::string& here) {
  return navigation(
      places_of(two_reports(), {{"Data", "Cite", "cite"}, {"Solvers", "Beside", "beside"}}), here);
}

TEST(Navigation, HasAWordForEachGroupAndThePlacesOfItsOwn) {
  const std::string links = links_at("comparison");
  EXPECT_THAT(links, AllOf(HasSubstr("<a href=\"../index.html\">ricochet</a>"),
                           HasSubstr("<a href=\"../small &amp; fine/index.html\">Simulation</a>"),
                           HasSubstr("<a href=\"../cite/index.html\">Data</a>"),
                           HasSubstr("<a href=\"../comparison/index.html\" aria-current=\"page\">"),
                           HasSubstr("<a href=\"../beside/index.html\">Beside</a>"),
                           HasSubstr("<a href=\"../comparison/count/index.html\">count</a>")));
  EXPECT_THAT(links, AllOf(Not(HasSubstr("Machine")), Not(HasSubstr("Proof of the impacts: small")),
                           Not(HasSubstr("crumbs"))));
}

TEST(Navigation, OfAPageOfAReportLeadsBackToItAndThatOfTheFrontPageHasNone) {
  EXPECT_THAT(links_at("comparison/count"),
              AllOf(HasSubstr("<a href=\"../../comparison/index.html\">All solvers</a> › count"),
                    HasSubstr("<a href=\"../../comparison/top-speed/index.html\">"),
                    HasSubstr("count/index.html\" aria-current=\"page\"")));
  EXPECT_THAT(links_at(""), AllOf(HasSubstr("<a href=\"index.html\" aria-current=\"page\">"),
                                  Not(HasSubstr("top-speed"))));
}

using LinkPages = TemporaryFolder;

TEST_F(LinkPages, PutsTheLinksWhereThePageHasRoomAndDoesSoAgain) {
  const auto page = write_file(folder_ / "comparison" / "index.html",
                               "a<!-- navigation -->old<!-- /navigation -->b");
  const std::vector<Place> places = places_of(two_reports(), {});
  for (int times = 0; times < 2; ++times) link_pages(folder_, places);
  EXPECT_EQ(text_of(page),
            "a<!-- navigation -->\n" + navigation(places, "comparison") + "<!-- /navigation -->b");
  EXPECT_FALSE(fs::exists(folder_ / "small & fine"));
}

using PageMark = TemporaryFolder;

TEST_F(PageMark, IsWhereTextIsPutAndNotMissedWhereThereIsNone) {
  for (const auto& [before, after] :
       {std::pair("a<!-- here --><!-- /here -->z", "a<!-- here -->\nnew\n<!-- /here -->z"),
        {"a<!-- here -->\nold\n<!-- /here -->z", "a<!-- here -->\nnew\n<!-- /here -->z"},
        {"a<!-- here -->z", "a<!-- here -->z"},
        {"a<!-- /here --><!-- here -->z", "a<!-- /here --><!-- here -->z"}}) {
    const auto page = write_file(folder_ / "index.html", before);
    put_at(page, "here", "new\n");
    EXPECT_EQ(text_of(page), after);
  }
  put_at(folder_ / "none.html", "here", "new");
  EXPECT_FALSE(fs::exists(folder_ / "none.html"));
}

/// The summary of a page that is made of these reports.
template <class Page>
std::string summary(const Page& page, const std::vector<FoundReport>& reports) {
  const OwnFiles own = page(site_results(reports));
  EXPECT_THAT(own.failures, IsEmpty());
  return own.files.at("summary.md");
}

TEST(CitePage, WithoutAComparisonLeavesItsRunsOut) {
  EXPECT_THAT(summary(cite_page, {}),
              AllOf(Not(HasSubstr("How do I repeat it?")), HasSubstr("How do I cite it?")));
}

TEST(FrontPage, ShowsWhatTheFirstReportsOfAKindSayByTheirNames) {
  FoundReport second = found_comparison();
  second.folder = "other";
  second.results->values.front().second = std::string("Found: nothing.");
  EXPECT_THAT(summary(front_page, {found_comparison(), second}),
              AllOf(HasSubstr("Found: all."), HasSubstr("| count | 100 | scan, count | 50 |"),
                    HasSubstr("(comparison/summary.md)"), HasSubstr("(other/summary.md)"),
                    HasSubstr("Not computed here: The paper's cases")));
  EXPECT_THAT(front_page(site_results({found_comparison()})).files.at("index.html"),
              HasSubstr("<svg"));
}

TEST(FrontPage, OfNoReportsSaysHowToMakeThem) {
  EXPECT_THAT(summary(front_page, {}),
              AllOf(HasSubstr("./ricochet reproduce"), HasSubstr("./ricochet compare"),
                    Not(HasSubstr("Which solver, when?\n\n|"))));
}

TEST(FrontPage, LeavesOutWhatTheDataOfAnotherVersionLack) {
  FoundReport older = found_comparison();
  ricochet::Table leaders{"leaders", columns_named("family,budget")};
  leaders.add("count", 100);
  older.results->tables = {leaders};
  EXPECT_THAT(summary(front_page, {older}),
              AllOf(HasSubstr("Found: all."), HasSubstr("| count | 100 | ")));
}

/// Three machines; of B the paper has no threshold, C is loud at once.
ricochet::Table three_machines() {
  ricochet::Table table{"thresholds",
                        columns_named("case,restitution,friction,disturbance,silent_up_to,"
                                      "quiet_up_to,paper_threshold,quiet_error")};
  table.add("A", 0.1, 0.4, 0, 2.0, 12.0, 13.0, 12.0 / 13 - 1);
  table.add("B", 0.1, 0.1, 1, 1.0, 4.0, std::nullopt, std::nullopt);
  table.add("C", 0.9, 0.1, 0, std::nullopt, std::nullopt, 2.0, std::nullopt);
  return table;
}

TEST(MachinePage, HasTheSpeedsOfTheLongRun) {
  report::Results cases;
  cases.set("moves", "Much moves it.");
  cases.add(three_machines());
  EXPECT_THAT(summary(machine_page, {made_up("reproduction", cases)}),
              AllOf(HasSubstr("The paper's 3 machines stay quiet up to 4.0 to 12.0 rad/s (38 to "
                              "115 rpm)"),
                    HasSubstr("| A | 0.1 | 0.4 | 0 | 2.00 | 12.00 | 13 | -8 |"),
                    HasSubstr("Much moves it."), HasSubstr("(regimes-of-the-machines.svg)"),
                    Not(HasSubstr("Does the level of the model matter?"))));
}

TEST(MachinePage, OfNoReportsSaysHowToDescribeAMachine) {
  EXPECT_THAT(summary(machine_page, {}),
              AllOf(HasSubstr("./ricochet machine new"), HasSubstr("Top speed in the"),
                    Not(HasSubstr("What moves"))));
}

TEST(RegimesChart, HasAColumnForEachMachineAndThePapersThresholds) {
  const report::Chart chart = regimes_chart(three_machines());
  EXPECT_NO_THROW(check(chart));
  EXPECT_THAT(chart.x.categories, ElementsAre("A", "B", "C"));
  ASSERT_EQ(chart.areas.size(), 3U);
  ASSERT_EQ(chart.areas[1].parts.size(), 2U) << "C is quiet nowhere";
  EXPECT_THAT(chart.areas[1].parts[1][0].between, FieldsAre(1.0, 4.0));
  EXPECT_EQ(chart.areas[2].parts.at(2).at(0).between.lower, 0.0);
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_EQ(chart.series[0].samples.size(), 2U) << "B has none";
}

/// What the page says of stiff and soft walls holds in the committed reports.
TEST(MachinePage, ReadsTheReference) {
  const report::Results site =
      site_results(found_reports(fs::path(RICOCHET_SOURCE) / "reports/reference"));
  const ricochet::Table* walls = site.table("simulators-walls");
  ASSERT_TRUE(walls);
  ASSERT_GT(walls->rows.size(), 1U);
  EXPECT_LT((*walls)[0].number("share"), 0.5);
  EXPECT_GT((*walls)[walls->rows.size() - 1].number("share"), 0.9);
}

}  // namespace
}  // namespace ricochet::site
