#include "src/report/page.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>

#include "ricochet/error.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;
using testing::UnorderedElementsAre;

class PageFiles : public testing::Test {
 protected:
  PageFiles()
      : root_(fs::path(testing::TempDir()) /
              (std::string("page_") + std::to_string(getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(root_);
  }
  ~PageFiles() override { fs::remove_all(root_); }

  static std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

  static std::set<std::string> names(const fs::path& folder) {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
      found.insert(entry.path().filename().string());
    return found;
  }

  /// Of pages with nothing wrong.
  static void write_page(const Page& page, const fs::path& folder) {
    EXPECT_THAT(report::write_page(page, folder), testing::IsEmpty());
  }

  fs::path root_;
};

Page page_with(const std::vector<std::string>& charts) {
  Section section{.id = "first", .heading = "First & foremost", .paragraphs = {"1 < 2"}};
  section.tables.push_back({"A <table>", {{"case"}}, {{{"C1"}}}});
  for (const std::string& name : charts) {
    Chart chart = line_chart({{0, 1}, {1, 2}});
    chart.name = name;
    section.figures.push_back({chart, "Caption of " + name + " <x>"});
  }
  return {"Title <script>", {"Intro, see https://example.org/a."}, {section}};
}

TEST_F(PageFiles, AreThePageTheSummaryAndTheCharts) {
  write_page(page_with({"one", "two"}), root_ / "a" / "b");
  EXPECT_THAT(names(root_ / "a" / "b"), UnorderedElementsAre("index.html", "manifest.txt",
                                                             "summary.md", "one.svg", "two.svg"));
}

TEST_F(PageFiles, HoldEverythingInOneHtmlFile) {
  write_page(page_with({"one"}), root_);
  const std::string html = read(root_ / "index.html");
  EXPECT_THAT(html, AllOf(HasSubstr("<html lang=\"en\">"), HasSubstr(read(root_ / "one.svg")),
                          HasSubstr("href=\"#first\""), HasSubstr("<section id=\"first\"")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("<script src")), Not(HasSubstr("<link")),
                          Not(HasSubstr("<img")), Not(HasSubstr("@import"))));
}

TEST_F(PageFiles, HaveTheNumbersOfEveryChartAndAScriptThatOffersThem) {
  write_page(page_with({"one", "two"}), root_);
  const std::string html = read(root_ / "index.html");
  std::size_t charts = 0;
  for (std::size_t at = 0; (at = html.find("class=\"chart-csv\">", at)) != std::string::npos;
       ++at) {
    ++charts;
  }
  EXPECT_EQ(charts, 2);
  EXPECT_THAT(html, AllOf(HasSubstr("path,1,2\\n"), HasSubstr("figure > script.chart-csv")));
  write_page(page_with({}), root_);
  EXPECT_THAT(read(root_ / "index.html"), Not(HasSubstr("<script")));
}

TEST_F(PageFiles, BeginWithTheAnswerThenTheChartAndFoldTheRest) {
  Page page = page_with({"one"});
  page.background = {"Why we ask."};
  page.sections[0].notes = {"How we did it."};
  write_page(page, root_);
  const std::string html = read(root_ / "index.html");
  const std::string summary = read(root_ / "summary.md");
  const auto expect_order = [](const std::string& text, const std::vector<const char*>& parts) {
    std::size_t last = 0;
    for (const char* part : parts) {
      const std::size_t at = text.find(part);
      ASSERT_NE(at, std::string::npos) << part;
      EXPECT_GT(at, last) << part;
      last = at;
    }
  };
  expect_order(html, {"Intro, see", "<details", "Why we ask.", "1 &lt; 2", "<svg", "Caption of one",
                      "<table", "<details class=\"notes\">\n<summary>How", "How we did it."});
  expect_order(summary, {"Intro, see", "one.svg", "Caption of one", "| case |", "How we did it.",
                         "## What this report asks", "Why we ask."});
}

TEST_F(PageFiles, ShowTenRowsOfALongTableUntilTheReaderAsksForAll) {
  for (const std::size_t rows : {12U, 13U}) {
    Page page = page_with({});
    page.sections[0].tables[0].rows.assign(rows, {{"C1"}});
    write_page(page, root_);
    const std::string html = read(root_ / "index.html");
    static const std::regex later("<tr class=\"later\">");
    const auto folded = std::distance(std::sregex_iterator(html.begin(), html.end(), later), {});
    EXPECT_EQ(folded, rows == 12 ? 0 : 3);
    EXPECT_EQ(html.find("Show all 13 rows") != std::string::npos, rows == 13);
  }
}

TEST_F(PageFiles, ShowCommandsAsTheyAreLineByLine) {
  Page page = page_with({});
  page.sections[0].code = {"first <x>\n  second"};
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "index.html"),
              HasSubstr("<pre tabindex=\"0\">first &lt;x&gt;\n  second</pre>"));
  EXPECT_THAT(read(root_ / "summary.md"), HasSubstr("```text\nfirst <x>\n  second\n```"));
}

/// The colours that the style replaces in the dark are those that charts are drawn in.
TEST_F(PageFiles, KnowTheColoursOfTheirCharts) {
  Page page = page_with({"one", "two"});
  Chart& lines = page.sections[0].figures[0].chart;
  Chart& points = page.sections[0].figures[1].chart;
  const Series series = lines.series[0];
  lines.series.clear();
  points.series.clear();
  for (int i = 0; i < 7; ++i) {
    lines.series.push_back(
        {std::to_string(i), Mark::line, {{0, 1, Range{0, 2}}, {1, 2, Range{1, 3}}}});
    points.series.push_back({std::to_string(i), Mark::points, series.samples});
  }
  lines.lines = {{Direction::vertical, 0.2, "first"},
                 {Direction::vertical, 0.4, "second"},
                 {Direction::vertical, 0.6, "third"}};
  write_page(page, root_);
  const std::string html = read(root_ / "index.html");
  const std::string svgs =
      read(root_ / "one.svg") + read(root_ / "two.svg") + read(RICOCHET_SOURCE "/docs/machine.svg");
  static const std::regex replaced("figure svg \\[(\\w+=\"[^\"]*\")\\]");
  int colours = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), replaced), end; it != end; ++it) {
    EXPECT_NE(svgs.find((*it)[1].str()), std::string::npos) << (*it)[1];
    ++colours;
  }
  EXPECT_GT(colours, 10);
}

TEST_F(PageFiles, SayWhyAChartIsMissingAndKeepAllElse) {
  Page page = page_with({"one", "wrong", "unmade", "two"});
  auto& figures = page.sections[0].figures;
  figures[1].chart.series[0].samples = {{0, std::nan("")}};
  figures[2].failure = "the data lack <speed>";
  EXPECT_THAT(report::write_page(page, root_),
              testing::UnorderedElementsAre(
                  AllOf(HasSubstr("chart wrong"), HasSubstr("sample 0: nan is not finite")),
                  "chart unmade could not be drawn: the data lack <speed>"));
  EXPECT_THAT(names(root_), UnorderedElementsAre("index.html", "manifest.txt", "summary.md",
                                                 "one.svg", "two.svg"));
  const std::string html = read(root_ / "index.html"), summary = read(root_ / "summary.md");
  EXPECT_THAT(html, AllOf(HasSubstr(read(root_ / "one.svg")), HasSubstr(read(root_ / "two.svg")),
                          HasSubstr("nan is not finite</p>"), HasSubstr("lack &lt;speed&gt;</p>"),
                          HasSubstr("Caption of wrong")));
  EXPECT_THAT(summary, AllOf(HasSubstr("(one.svg)"), HasSubstr("(two.svg)"),
                             HasSubstr("nan is not finite**"), Not(HasSubstr("(wrong.svg)"))));
}

TEST_F(PageFiles, EscapeHtml) {
  write_page(page_with({"one"}), root_);
  EXPECT_THAT(read(root_ / "index.html"),
              AllOf(HasSubstr("Title &lt;script&gt;"), HasSubstr("First &amp; foremost"),
                    HasSubstr("<p>1 &lt; 2</p>"), HasSubstr("A &lt;table&gt;"),
                    HasSubstr("Caption of one &lt;x&gt;"),
                    HasSubstr("<a href=\"https://example.org/a\">")));
}

TEST_F(PageFiles, ShowTheChartsInTheSummary) {
  write_page(page_with({"one"}), root_);
  EXPECT_THAT(read(root_ / "summary.md"),
              AllOf(HasSubstr("# Title &lt;script>\n"), HasSubstr("## First &amp; foremost\n"),
                    HasSubstr("| C1 |"), HasSubstr("![A title](one.svg)\n\nCaption of one")));
}

Page page_of(const Table& table) {
  return {"Title", {}, {{.id = "first", .heading = "First", .tables = {table}}}};
}

const Table thresholds{"Thresholds [rad/s]",
                       {{"case", Alignment::left}, {"threshold"}},
                       {{{"C1"}, {"8.97", State::good}}, {{"C2"}, {"3", State::bad}}}};

TEST_F(PageFiles, LetTheReaderChooseAmongChartsAndSummariseThemAll) {
  Page page = page_with({"always", "quiet-1", "quiet-2", "loud-1", "loud-2"});
  auto& figures = page.sections[0].figures;
  figures[1].choice = figures[3].choice = "C1";
  figures[2].choice = figures[4].choice = "C<2>";
  write_page(page, root_);
  const std::string html = read(root_ / "index.html"), summary = read(root_ / "summary.md");
  const std::regex buttons("<input type=\"radio\"[^>]*?( checked)?><label[^>]*>([^\n]*)</label>");
  std::vector<std::string> choices;
  for (std::sregex_iterator it(html.begin(), html.end(), buttons), end; it != end; ++it) {
    choices.push_back((*it)[2].str() + (*it)[1].str());
  }
  EXPECT_THAT(choices, testing::ElementsAre("C1 checked", "C&lt;2&gt;"));
  std::vector<std::size_t> places;  // the charts of a choice follow each other
  for (const char* name : {"always", "quiet-1", "loud-1", "quiet-2", "loud-2"}) {
    places.push_back(html.find(std::string("id=\"") + name + "-title\""));
    EXPECT_THAT(summary, HasSubstr(std::string("](") + name + ".svg)"));
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  EXPECT_NE(places.back(), std::string::npos);
}

TEST_F(PageFiles, ShowTheLastFrameUntilTheSliderIsMoved) {
  Page page = page_with({"slow", "fast", "other"});
  auto& figures = page.sections[0].figures;
  figures[0].choice = figures[1].choice = figures[2].choice = "C1";
  figures[0].frame = "3 rad/s";
  figures[1].frame = "9 rad/s";
  write_page(page, root_);
  const std::string html = read(root_ / "index.html");
  EXPECT_THAT(html, HasSubstr("<figure hidden data-frame=\"3 rad/s\""));
  EXPECT_THAT(html, HasSubstr("<figure data-frame=\"9 rad/s\""));
  EXPECT_THAT(html, HasSubstr("min=\"0\" max=\"1\" value=\"1\""));
  EXPECT_THAT(html, HasSubstr("<script>"));
  EXPECT_THAT(read(root_ / "summary.md"),
              AllOf(HasSubstr("(fast.svg)"), HasSubstr("(other.svg)"), Not(HasSubstr("slow"))));
}

TEST_F(PageFiles, FoldAwayWhatHasAFold) {
  Page page = page_with({"shown", "folded"});
  page.sections[0].figures[1].fold = "The <rest>";
  write_page(page, root_);
  const std::string html = read(root_ / "index.html");
  const auto fold = html.find("<summary>The &lt;rest&gt;</summary>");
  ASSERT_NE(fold, std::string::npos);
  EXPECT_LT(html.find("shown-title"), fold);
  EXPECT_GT(html.find("folded-title"), fold);
  EXPECT_THAT(html, Not(HasSubstr("frames.querySelector")));
  EXPECT_THAT(read(root_ / "summary.md"), HasSubstr("(folded.svg)"));
}

/// The style shows as many choices as it has rules for.
TEST_F(PageFiles, OfferNoMoreChoicesThanTheStyleShows) {
  Page page = page_with({});
  for (int i = 0; i < 25; ++i) {
    Chart chart = line_chart({{0, 1}, {1, 2}});
    chart.name = "chart-" + std::to_string(i);
    page.sections[0].figures.push_back({chart, "", std::to_string(i)});
  }
  EXPECT_THROW(write_page(page, root_), std::invalid_argument);
  page.sections[0].figures.pop_back();
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "index.html"), HasSubstr("input:nth-of-type(24):checked"));
}

TEST_F(PageFiles, HaveTablesInMarkdown) {
  write_page(page_of(thresholds), root_);
  EXPECT_EQ(read(root_ / "summary.md"),
            "# Title\n\n## First\n\n"
            "Thresholds [rad/s]\n\n"
            "| case | threshold |\n"
            "| :--- | ---: |\n"
            "| C1 | ✓ 8.97 |\n"
            "| C2 | ✗ 3 |\n");
}

TEST_F(PageFiles, LinkCellsToPagesAndPlaces) {
  Page page = page_with({});
  page.sections[0].tables[0].rows = {{{.text = "a", .link = "../a&b"}},
                                     {{.text = "b", .link = "#first"}},
                                     {{.text = "c", .link = "c#there"}}};
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "index.html"),
              AllOf(HasSubstr("<a href=\"../a&amp;b/index.html\">a</a>"),
                    HasSubstr("<a href=\"#first\">b</a>"),
                    HasSubstr("<a href=\"c/index.html#there\">c</a>")));
  EXPECT_THAT(read(root_ / "summary.md"), HasSubstr("[c](c/summary.md#there)"));
}

TEST_F(PageFiles, KeepAChoiceInALinkOfTheHtmlAlone) {
  Page page = page_with({});
  page.sections[0].tables[0].rows = {{{.text = "a", .link = "../view#family=hs&entry=b,+c"}}};
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "index.html"),
              HasSubstr("<a href=\"../view/index.html#family=hs&amp;entry=b,+c\">a</a>"));
  EXPECT_THAT(read(root_ / "summary.md"), HasSubstr("[a](../view/summary.md)"));
}

TEST_F(PageFiles, HaveTheDataOfAViewOfRunsWithItsScripts) {
  Page page = page_with({});
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "index.html"), Not(HasSubstr("view-form")));
  page.sections[0].view = {{"runs", {{{"a", "</script>"}, {"b", 1}}, {{"a", "x"}, {"b", 2}}}}};
  write_page(page, root_);
  const std::string html = read(root_ / "index.html");
  EXPECT_THAT(html,
              HasSubstr(R"({"runs":{"columns":["a","b"],"rows":[["\u003c/script>",1],["x",2]]}})"));
  for (const char* part : {"id=\"view-form\"", ".view-form {", "class RunTable", "class Choice",
                           "class Chart", "new RunTable("}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  EXPECT_THAT(read(root_ / "summary.md"), Not(HasSubstr("runs")));
}

TEST_F(PageFiles, ShowStatesByColourAndByText) {
  write_page(page_of(thresholds), root_);
  EXPECT_THAT(read(root_ / "index.html"),
              AllOf(HasSubstr("<th scope=\"row\" class=\"left\">C1</th><td"),
                    HasSubstr("class=\"right good\""), HasSubstr("aria-label=\"good\">✓<"),
                    HasSubstr("class=\"right bad\""), HasSubstr("aria-label=\"bad\">✗<")));
}

TEST_F(PageFiles, EscapeTablesEverywhere) {
  write_page(page_of({"<i>", {{"<i>"}}, {{{"<i>", State::good}}, {{"<i>"}}}}), root_);
  EXPECT_THAT(read(root_ / "index.html"), AllOf(HasSubstr("&lt;i&gt;"), Not(HasSubstr("<i>"))));
  write_page(page_of({"", {{"a|b"}}, {{{"c\nd|e"}}}}), root_);
  EXPECT_THAT(read(root_ / "summary.md"), AllOf(HasSubstr("| a\\|b |"), HasSubstr("| c d\\|e |")));
}

TEST_F(PageFiles, LinkOtherPagesInTheSummary) {
  Page page = page_with({"one"});
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "summary.md"), Not(HasSubstr("summary.md")));
  page.further = {"count", "top-speed"};
  page.above = "The problems";
  write_page(page, root_);
  EXPECT_THAT(read(root_ / "summary.md"),
              AllOf(HasSubstr("\n## Further pages\n\n- [count](count/summary.md)\n"
                              "- [top-speed](top-speed/summary.md)\n"),
                    HasSubstr("\nPart of [The problems](../summary.md).\n")));
}

TEST_F(PageFiles, HaveNoRowOfTheWrongLength) {
  EXPECT_THROW(write_page(page_of({"t", {{"a"}, {"b"}}, {{{"1"}}}}), root_), std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(PageFiles, ReplaceAnEarlierReportAndNothingElse) {
  write_page(page_with({"old", "both"}), root_);
  write(root_ / "notes.txt", "mine");
  write(root_ / "logo.svg", read(root_ / "old.svg"));  // drawn by ricochet simulate --plot
  write_page(page_with({"both", "new"}), root_);
  EXPECT_THAT(names(root_), UnorderedElementsAre("index.html", "manifest.txt", "summary.md",
                                                 "both.svg", "new.svg", "notes.txt", "logo.svg"));
  EXPECT_EQ(read(root_ / "notes.txt"), "mine");
}

TEST_F(PageFiles, LeaveWhatTheUserHasChangedSince) {
  write_page(page_with({"old"}), root_);
  write(root_ / "old.svg", "<svg class=\"ricochet-chart\">mine</svg>");
  write_page(page_with({"new"}), root_);
  EXPECT_TRUE(fs::exists(root_ / "old.svg"));
}

TEST_F(PageFiles, OfAManifestThatSomeoneWroteTouchNothingElsewhere) {
  write_page(page_with({"old"}), root_ / "a");
  write_page(page_with({"old"}), root_ / "b");
  write(root_ / "a" / "manifest.txt",
        std::regex_replace(read(root_ / "a" / "manifest.txt"), std::regex("old"), "../b/old"));
  write_page(page_with({"new"}), root_ / "a");
  EXPECT_TRUE(fs::exists(root_ / "b" / "old.svg"));
}

TEST_F(PageFiles, AreTheSameBytesEveryTime) {
  write_page(page_with({"one"}), root_ / "a");
  write_page(page_with({"one"}), root_ / "b");
  EXPECT_EQ(read(root_ / "a" / "index.html"), read(root_ / "b" / "index.html"));
}

TEST_F(PageFiles, AreNotWrittenIntoAFolderThatCannotBe) {
  write(root_ / "file", "mine");
  for (const fs::path& folder : {root_ / "file", root_ / "file" / "deeper" / "still"})
    EXPECT_THAT([&] { write_page(page_with({"one"}), folder); },
                ThrowsMessage<InputError>(
                    AllOf(HasSubstr((root_ / "file").string()), Not(HasSubstr("\n")))));
  EXPECT_THAT(names(root_), UnorderedElementsAre("file"));
  EXPECT_EQ(read(root_ / "file"), "mine");
}

TEST_F(PageFiles, StayAsTheyWereIfOneCannotBeReplaced) {
  write_page(page_with({"old"}), root_);
  const std::string before = read(root_ / "index.html");
  fs::create_directory(root_ / "new.svg");
  EXPECT_THROW(write_page(page_with({"new"}), root_), InputError);
  EXPECT_EQ(read(root_ / "index.html"), before);
  EXPECT_THAT(names(root_), UnorderedElementsAre("index.html", "manifest.txt", "summary.md",
                                                 "old.svg", "new.svg"));
}

TEST_F(PageFiles, AreNotWrittenIfNamesRepeat) {
  EXPECT_THROW(write_page(page_with({"one", "one"}), root_), std::invalid_argument);
  Page page = page_with({});
  page.sections.push_back(page.sections.front());
  EXPECT_THROW(write_page(page, root_), std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(root_));
}

}  // namespace
}  // namespace ricochet::report
