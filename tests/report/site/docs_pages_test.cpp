#include <gmock/gmock.h>

#include <iterator>
#include <regex>
#include <set>

#include "src/report/site/site.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

std::string document_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class DocsPages : public TemporaryFolder {};

TEST_F(DocsPages, HaveEveryDocumentOfTheRepository) {
  const Place place = write_docs_pages(folder_, {});
  std::set<std::string> pages(place.pages.begin(), place.pages.end()), documents;
  for (const auto& entry : fs::directory_iterator(fs::path(RICOCHET_SOURCE) / "docs")) {
    if (entry.path().extension() == ".md") documents.insert(entry.path().stem().string());
  }
  EXPECT_EQ(pages, documents);
}

TEST_F(DocsPages, HaveLinksThatLeadSomewhereInTheSite) {
  keep(folder_, "reproduction", Json::object());
  std::ofstream(folder_ / "reproduction" / "index.html") << "there";
  const Place place = write_docs_pages(folder_, {});
  static const std::regex link("href=\"([^\"#]*)(#[^\"]*)?\"");
  int links = 0;
  for (const std::string& page : place.pages) {
    const fs::path own = folder_ / docs_folder / page / "index.html";
    const std::string text = document_text(own);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      if ((*it)[1].str().starts_with("https://")) continue;
      const fs::path target = (*it)[1].length() == 0 ? own : own.parent_path() / (*it)[1].str();
      ASSERT_TRUE(fs::exists(target)) << page << ": " << it->str();
      ++links;
      const std::string anchor = (*it)[2];
      if (anchor.empty()) continue;
      EXPECT_THAT(document_text(target), testing::HasSubstr("id=\"" + anchor.substr(1) + "\""))
          << page << ": " << it->str();
    }
  }
  EXPECT_GT(links, 50);
  EXPECT_THAT(document_text(folder_ / "docs/reports/index.html"),
              testing::HasSubstr("href=\"../../reproduction/index.html\""));
}

TEST_F(DocsPages, HaveTheSketchOfTheMachine) {
  write_docs_pages(folder_, {});
  EXPECT_THAT(document_text(folder_ / "docs/machine-files/index.html"),
              testing::HasSubstr("<img src=\"../machine.svg\" alt=\"The machine: "));
  EXPECT_EQ(document_text(folder_ / "docs/machine.svg"),
            document_text(fs::path(RICOCHET_SOURCE) / "docs/machine.svg"));
}

TEST_F(DocsPages, CanBeSearchedWithTheReports) {
  FoundReport report = made_up("verification", Json::object(), "proof");
  report.headline->finding = "No </script> is wrong.";
  fs::create_directories(folder_ / "proof");
  std::ofstream(folder_ / "proof/summary.md")
      << "# Proof\n\n<!-- part: nlopt-cobyla x -->\n\n### nlopt-cobyla\n\nPowell's.\n\n"
         "#### Where?\n\nThere.\n\n| a | b |\n|:--|:--|\n| row | cell |\n";
  std::ofstream(folder_ / "proof/index.html") << "<div id=\"nlopt-cobyla\"></div>";
  write_docs_pages(folder_, {report});
  const std::string page = document_text(folder_ / "docs/index.html");
  EXPECT_THAT(page, testing::HasSubstr("../proof/index.html"));
  EXPECT_THAT(page, testing::HasSubstr("No \\u003c/script> is wrong."));
  const std::size_t list = page.find("id=\"texts\">") + 11;
  const Json entries = Json::parse(page.substr(list, page.find("</script>", list) - list));
  const auto solver = std::ranges::find(entries, "../proof/index.html#nlopt-cobyla",
                                        [](const Json& entry) { return entry["address"]; });
  ASSERT_NE(solver, entries.end());
  EXPECT_EQ((*solver)["page"], "Proof");
  EXPECT_EQ((*solver)["heading"], "nlopt-cobyla");
  EXPECT_THAT((*solver)["text"].get<std::string>(), testing::HasSubstr("Where? There."));
  EXPECT_THAT((*solver)["text"].get<std::string>(), testing::Not(testing::HasSubstr("cell")));
  EXPECT_THAT(page, testing::HasSubstr("threshold-and-regimes/index.html#what-is-quiet"));
}

}  // namespace
}  // namespace ricochet::site
