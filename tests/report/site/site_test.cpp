#include "src/report/site/site.h"

#include <regex>

#include "ricochet/error.h"
#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

const fs::path repository = RICOCHET_SOURCE, reference_reports = repository / "reports/reference";

Json committed_data(const char* report) {
  return report::data_in(text_of(reference_reports / report / "data.json"));
}

/// Of a small report, which no test changes.
const Json& verification_data() {
  static const Json data = committed_data("verification");
  return data;
}

using FoundReports = TemporaryFolder;

TEST_F(FoundReports, AreThoseOfKnownKindsInTheirOrder) {
  keep(folder_, "zebra", {{"report", "reproduction"}});
  keep(folder_, "surrogate", {{"report", "surrogate"}});
  keep(folder_, "ant", {{"report", "reproduction"}});
  keep(folder_, "reference", {{"report", "site"}});
  keep(folder_, "other", {{"report", 7}});
  keep(folder_, "list", Json::array({1}));
  fs::create_directories(folder_ / "empty");
  write_file(folder_ / "broken" / "data.json", "{");
  std::vector<std::string> labels;
  for (const FoundReport& report : found_reports(folder_)) labels.push_back(label_of(report));
  EXPECT_THAT(labels,
              ElementsAre("The paper's cases: ant", "The paper's cases: zebra", "Surrogate"));
  EXPECT_THAT(folders_of_data(folder_),
              ElementsAre("ant", "broken", "list", "other", "surrogate", "zebra"))
      << "what is not of a known kind may have been a report";
  EXPECT_TRUE(found_reports("/nowhere").empty());
}

TEST_F(FoundReports, AreNotReadDeeperThanTheStackHolds) {
  const std::size_t levels = 200'000;
  write_file(folder_ / "surrogate" / "data.json", R"({"report":"surrogate","deep":)" +
                                                      std::string(levels, '[') +
                                                      std::string(levels, ']') + "}");
  EXPECT_TRUE(found_reports(folder_).empty());
  EXPECT_THAT(folders_of_data(folder_), ElementsAre("surrogate"));
}

TEST_F(FoundReports, HaveTheirPagesAndWhatTheseSayOfThemselves) {
  Json data = found_comparison().data;
  data["pages"] = {"robustness", "gone"};
  data["made"] = {{"date", "2031-02-03"}, {"seconds", 1.5}, {"quick", false}};
  keep(folder_, "comparison", data);
  keep(folder_, "comparison/robustness",
       {{"report", "comparison_failures"}, {"values", {{"finding", "Noise harms."}}}});
  const auto reports = found_reports(folder_);
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].made.date, "2031-02-03");
  EXPECT_EQ(*reports[0].results->value("made.seconds"), Value(1.5));
  using testing::_;
  const auto headline = FieldsAre(_, "Noise harms.", _, "Robustness", _);
  EXPECT_THAT(reports[0].pages, ElementsAre(FieldsAre("robustness", testing::Optional(headline)),
                                            FieldsAre("gone", Not(testing::Optional(_)))));
}

TEST_F(FoundReports, OfAnotherVersionHaveNoHeadline) {
  keep(folder_, "verification", {{"report", "verification"}, {"values", "Found: all"}});
  keep(folder_, "surrogate", {{"report", "surrogate"}});  // and nothing else
  EXPECT_EQ(found_reports(folder_).size(), 2U);
  for (const FoundReport& report : found_reports(folder_)) EXPECT_FALSE(report.headline);
}

class Site : public TemporaryFolder {
 protected:
  std::string text(const std::string& file) const { return text_of(folder_ / file); }
};

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
  EXPECT_THAT(
      text("reports/index.html"),
      AllOf(HasSubstr("No count called certain is wrong."), HasSubstr("./ricochet reproduce"),
            HasSubstr("The pages have only what this machine has computed")))
      << "without a reference it is not whole";
}

TEST_F(Site, IsWholeWithWhatTheReferenceHasWhichSaysSo) {
  const fs::path site = folder_ / "reports", reference = folder_ / "reference";
  Json surrogate = committed_data("surrogate"), inner = verification_data();
  surrogate["made"]["date"] = "2031-02-03";
  surrogate["pages"] = {"inner"};
  inner.erase("made");
  keep(reference, "surrogate", surrogate);
  keep(reference, "surrogate/inner", inner);
  keep(reference, "verification", verification_data());
  keep(reference, "fireworks", committed_data("fireworks"));
  keep(site, "mine", verification_data());
  write_file(site / "fireworks" / "notes.txt", "mine");
  write_site_above(site / "mine", reference);

  for (const char* page : {"reports/surrogate/summary.md", "reports/surrogate/index.html"}) {
    EXPECT_THAT(text(page), HasSubstr("Of the committed reference, computed on 2031-02-03: this "
                                      "machine has not computed it."));
  }
  EXPECT_THAT(text("reports/surrogate/inner/summary.md"), HasSubstr("Of the committed reference"));
  EXPECT_THAT(text("reports/summary.md"),
              AllOf(HasSubstr("Computed on this machine: Proof of the impacts: mine. All else is "
                              "of the committed reference, computed on 2031-02-03."),
                    HasSubstr("| 2031-02-03 of the reference |")));
  EXPECT_FALSE(fs::exists(site / "verification")) << "this machine has one";
  EXPECT_FALSE(fs::exists(site / "fireworks/index.html")) << "somebody has something there";

  // What is drawn stays until the reference changes.
  write_file(site / "surrogate/index.html", "drawn");
  write_site(site, reference);
  EXPECT_EQ(text("reports/surrogate/index.html"), "drawn");
  surrogate["made"]["date"] = "2032-02-03";
  keep(reference, "surrogate", surrogate);
  write_site(site, reference);
  EXPECT_THAT(text("reports/surrogate/index.html"), HasSubstr("computed on 2032-02-03"));

  // This machine's own takes the place of the reference's.
  keep(site, "own", committed_data("surrogate"));
  write_site(site, reference);
  EXPECT_THAT(text("reports/summary.md"), Not(HasSubstr("of the committed reference")));
}

TEST_F(Site, IsDrawnAgainWithAllItsReportsTheLivePageAndTheirLinks) {
  keep(folder_ / "from", "verification", verification_data());
  ASSERT_TRUE(redraw_site(folder_ / "from", folder_ / "to"));
  EXPECT_FALSE(fs::exists(folder_ / "from/index.html"));
  EXPECT_THAT(text("to/verification/index.html"),
              HasSubstr("<a href=\"../index.html\">ricochet</a>"));
  const std::string first = text("to/index.html"), live = text("to/live/index.html");
  EXPECT_THAT(first, HasSubstr("<a href=\"live/index.html\">"));
  EXPECT_THAT(live, AllOf(HasSubstr("<a href=\"../verification/index.html\">"),
                          HasSubstr("<a href=\"../live/index.html\" aria-current=\"page\">"),
                          HasSubstr("<h1>A live machine</h1>")));
  EXPECT_LT(live.size(), 450'000U);
  ASSERT_TRUE(redraw_site(folder_ / "to", folder_ / "again"));
  EXPECT_EQ(text("again/index.html"), first);
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
  keep(folder_, "comparison", made_up("comparison", results).data);
  write_site(folder_, {});
  EXPECT_THAT(text("index.html"),
              AllOf(HasSubstr("&lt;i&gt;"), Not(HasSubstr("</script><b>")), Not(HasSubstr("<i>"))));
}

TEST_F(Site, ShowsThatDataAreOfAnotherVersion) {
  keep(folder_ / "from", "verification", {{"report", "verification"}});
  const auto failures = redraw_site(folder_ / "from", folder_ / "to");
  ASSERT_TRUE(failures);
  EXPECT_THAT(*failures,
              ElementsAre(StartsWith((folder_ / "from/verification/data.json").string() + ": ")));
  EXPECT_THAT(text("to/index.html"), HasSubstr("another version"));
}

TEST_F(Site, LinksNoPageOutsideOfIt) {
  keep(folder_ / "from", "verification",
       {{"report", "verification"}, {"pages", {"../../../outside"}}});
  const std::string other = "<!-- navigation -->kept<!-- /navigation -->";
  write_file(folder_ / "outside/index.html", other);
  fs::create_directories(folder_ / "to" / "site");
  ASSERT_TRUE(redraw_site(folder_ / "from", folder_ / "to" / "site"));
  EXPECT_EQ(text("outside/index.html"), other);
}

/// Expects the links of all pages below a folder to lead to pages and places in it. Returns how
/// many pages there are.
std::size_t expect_links_inside(const fs::path& folder) {
  static const std::regex link("<a [^>]*href=\"([^\"#?]*)[^\"#]*(#[^\"]*)?\"");
  std::size_t pages = 0, links = 0;
  for (const fs::path& page : fs::recursive_directory_iterator(folder)) {
    if (page.extension() != ".html") continue;
    ++pages;
    const std::string text = text_of(page);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1], anchor = (*it)[2];
      if (target.starts_with("https://")) continue;
      const fs::path there =
          target.empty() ? page : (page.parent_path() / target).lexically_normal();
      EXPECT_TRUE(there.string().starts_with(folder.string())) << it->str();
      EXPECT_TRUE(fs::exists(there)) << page << ": " << it->str();
      ++links;
      // What stands behind a = is a choice that a script reads.
      if (anchor.empty() || anchor.find('=') != std::string::npos) continue;
      EXPECT_NE(text_of(there).find("id=\"" + anchor.substr(1) + "\""), std::string::npos)
          << page << ": " << it->str();
    }
  }
  EXPECT_GT(links, 100U);
  return pages;
}

using PublishedSite = Site;

TEST_F(PublishedSite, IsCompleteAndHasNoLinkOutside) {
  keep(folder_ / "from", "verification", verification_data());
  const Publication written = publish_site(folder_ / "from", folder_ / "to");
  EXPECT_TRUE(written.failures.empty());
  for (const char* file : {"index.html", "verification/index.html", "cite/index.html",
                           "docs/index.html", "live/index.html", ".nojekyll"}) {
    EXPECT_TRUE(fs::exists(folder_ / "to" / file)) << file;
  }
  EXPECT_EQ(expect_links_inside(folder_ / "to"), written.pages);
  EXPECT_GT(written.bytes, 500'000U);
  EXPECT_THAT(text("to/docs/reports/index.html"),
              HasSubstr("href=\"../../verification/index.html\""));
  const Publication again = publish_site(folder_ / "from", folder_ / "to");
  EXPECT_TRUE(again.failures.empty());
  EXPECT_EQ(again.pages, written.pages);
}

TEST_F(PublishedSite, OverwritesNothingElse) {
  keep(folder_ / "from", "verification", verification_data());
  write_file(folder_ / "mine" / "letter", "dear");
  for (const auto& [from, to] : {std::pair("from", "mine"), {"from", "from"}, {"mine", "new"}})
    EXPECT_THROW(static_cast<void>(publish_site(folder_ / from, folder_ / to)), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "mine/index.html"));
}

/// What is committed of the reference.
using Reference = TemporaryFolder;

TEST_F(Reference, HasItsDataAsAReportWouldWriteThem) {
  int reports = 0;
  for (const fs::path& file : fs::recursive_directory_iterator(reference_reports)) {
    if (file.filename() != "data.json") continue;
    const std::string text = text_of(file);
    const Json data = report::data_in(text);
    EXPECT_TRUE(report::json_text(data) == text) << file;
    Json read = data;
    read.update(json_of(report::results_in(data)));
    EXPECT_TRUE(read == data) << file;
    ++reports;
  }
  EXPECT_GT(reports, 15);
}

TEST_F(Reference, IsWhatItsDataMakeOfIt) {
  EXPECT_THAT(publish_site(reference_reports, folder_ / "site").failures, ElementsAre());
  int compared = 0;
  for (const fs::path& file : fs::recursive_directory_iterator(reference_reports)) {
    if (file.extension() != ".md" && file.extension() != ".svg") continue;
    const fs::path drawn = folder_ / "site" / fs::relative(file, reference_reports);
    EXPECT_TRUE(fs::exists(drawn) && text_of(drawn) == text_of(file))
        << file << " is not what ./ricochet report reports/reference draws";
    ++compared;
  }
  EXPECT_GT(compared, 150);
}

using DocsPages = Site;

TEST_F(DocsPages, HaveEveryDocumentOfTheRepositoryAndTheSketchOfTheMachine) {
  const Place place = write_docs_pages(folder_, {});
  std::vector<std::string> documents;
  for (const fs::path& file : fs::directory_iterator(repository / "docs"))
    if (file.extension() == ".md") documents.push_back(file.stem());
  EXPECT_THAT(place.pages, testing::UnorderedElementsAreArray(documents));
  EXPECT_THAT(text("docs/machine-files/index.html"),
              HasSubstr("<img src=\"../machine.svg\" alt=\"The machine: "));
  EXPECT_EQ(text("docs/machine.svg"), text_of(repository / "docs/machine.svg"));
}

TEST_F(DocsPages, CanBeSearchedWithTheReports) {
  FoundReport report = made_up("verification", Json::object(), "proof");
  report.headline->finding = "No </script> is wrong.";
  write_file(folder_ / "proof/summary.md",
             "# Proof\n\n<!-- part: nlopt-cobyla x -->\n\n### nlopt-cobyla\n\nPowell's.\n\n"
             "#### Where?\n\nThere.\n\n| a | b |\n|:--|:--|\n| row | cell |\n");
  write_file(folder_ / "proof/index.html", "<div id=\"nlopt-cobyla\"></div>");
  write_docs_pages(folder_, {report});
  const std::string page = text("docs/index.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("../proof/index.html"), HasSubstr("No \\u003c/script> is wrong."),
                    HasSubstr("threshold-and-regimes/index.html#what-is-quiet")));
  const std::size_t list = page.find("id=\"texts\">") + 11;
  const Json entries = Json::parse(page.substr(list, page.find("</script>", list) - list));
  const auto solver = std::ranges::find(entries, "../proof/index.html#nlopt-cobyla",
                                        [](const Json& entry) { return entry["address"]; });
  ASSERT_NE(solver, entries.end());
  EXPECT_EQ((Json{(*solver)["page"], (*solver)["heading"]}), (Json{"Proof", "nlopt-cobyla"}));
  EXPECT_THAT((*solver)["text"].get<std::string>(),
              AllOf(HasSubstr("Where? There."), HasSubstr("row"), Not(HasSubstr("cell"))));
}

}  // namespace
}  // namespace ricochet::site
