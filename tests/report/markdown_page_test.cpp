#include "src/report/markdown_page.h"

#include <gmock/gmock.h>

#include <pugixml.hpp>
#include <regex>

#include "src/core/files.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PageSource page(const std::string& text) {
  return page_source("---\ngroup: Machine\n---\n" + text);
}

std::string filled_text(const std::string& text, const Results& results) {
  return filled_page(page(text), results);
}

Results results() {
  Results results;
  results.set("speed", 8.0567);
  results.set("nothing", std::optional<double>());
  results.set("name", "a|b_<c>");
  ricochet::Table table{"cases", {{"id"}, {"threshold", "threshold [rad/s]", ".2f"}}};
  table.add("C1", 8.05);
  table.add("C2", std::nullopt);
  results.add(table);
  results.add(ricochet::Table{"empty", {{"id"}}});
  results.add(Chart{.name = "counts",
                    .title = "Counts <rise>",
                    .x = {"speed"},
                    .y = {"count"},
                    .series = {{"a", Mark::line, {{0, 1}, {1, 2}}}}});
  return results;
}

TEST(MarkdownPage, FillsInValues) {
  EXPECT_EQ(filled_text("At {{speed:.1f}} rad/s.\n", results()), "At 8.1 rad/s.\n");
  EXPECT_EQ(filled_text("Of {{name}}\n", results()), "Of a\\|b\\_&lt;c>\n");
  EXPECT_EQ(filled_text("`run {{name}}`\n", results()), "`run a|b_<c>`\n");
  EXPECT_EQ(filled_text("```\n{{name}}\n\n{{speed:.0f}}\n```\n", results()),
            "```\na|b_<c>\n\n8\n```\n");
}

TEST(MarkdownPage, LeavesOutBlocksAndHeadingsWithoutValues) {
  EXPECT_EQ(filled_text("One.\n\nNo {{nothing}}\nat all.\n\nTwo.\n", results()), "One.\n\nTwo.\n");
  EXPECT_EQ(
      filled_text("# Page\n\n## A\n\n{{nothing}}\n\n### B\n\n{{table empty}}\n\n## C\n\nText.\n",
                  results()),
      "# Page\n\n## C\n\nText.\n");
  EXPECT_EQ(filled_text("- one\n- {{nothing}}\n- three\n", results()), "- one\n- three\n");
  EXPECT_EQ(filled_text("{{fold More}}\n\n{{nothing}}\n\n{{end}}\n\nText.\n", results()),
            "Text.\n");
}

TEST(MarkdownPage, LeavesOutASectionThatHasNothingOfWhatItAsksFor) {
  EXPECT_EQ(
      filled_text("# P\n\n## A\n\nWords.\n\n{{table empty}}\n\n### B\n\nMore.\n\n## C\n\nEnd.\n",
                  results()),
      "# P\n\n## C\n\nEnd.\n");
  EXPECT_EQ(filled_text("## A\n\nWords.\n\n{{table empty}}\n\nAt {{speed:.0f}}.\n", results()),
            "## A\n\nWords.\n\nAt 8.\n");
}

TEST(MarkdownPage, ShowsTheFirstRowsOfALongTable) {
  EXPECT_EQ(filled_text("{{rows 1}}\n| case |\n|:--|\n| {{cases.id}} |\n", results()),
            "| case |\n|:--|\n| C1 |\n\nThe first 1 of 2 rows; all are in `cases.csv`.\n");
}

TEST(MarkdownPage, RepeatsALineForEachRow) {
  EXPECT_EQ(filled_text("| case | speed |\n|:--|--:|\n| [{{cases.id}}]({{cases.id}}/) | "
                        "{{cases.threshold:.1f}} rad/s |\n",
                        results()),
            "| case | speed |\n|:--|--:|\n| [C1](C1/summary.md) | 8.1 rad/s |\n| "
            "[C2](C2/summary.md) | |\n");
  EXPECT_EQ(filled_text("- {{cases.id}}: {{cases.threshold}}\n", results()), "- C1: 8.05\n");
  EXPECT_EQ(filled_text("| id |\n|--|\n| {{empty.id}} |\n", results()), "");
}

TEST(MarkdownPage, ShowsTables) {
  EXPECT_THAT(filled_text("{{table cases}}\n", results()),
              AllOf(HasSubstr("| id | threshold [rad/s] |\n"), HasSubstr("| C1 | 8.05 |\n")));
  EXPECT_THAT(
      filled_text("{{table cases 1}}\n", results()),
      AllOf(HasSubstr("The first 1 of 2 rows; all are in `cases.csv`."), Not(HasSubstr("C2"))));
}

TEST(MarkdownPage, RepeatsABlockForEachPart) {
  Results all = results();
  for (const char* id : {"ipopt", "nlopt-cobyla"}) {
    Results own;
    own.set("kind", std::string(id) + "'s");
    own.add(Chart{.name = "ecdf", .title = id, .x = {"x"}, .y = {"y"}});
    all.add("solvers", {id, id, own});
  }
  const PageSource source = page(
      "# P\n\n## S\n\n{{choose solvers: Solver}}\n\n### {{kind}}\n\n{{chart ecdf}} Of "
      "{{speed:.0f}}.\n\n{{end}}\n\nEnd.\n");
  const auto [files, failures] = page_files(source, all);
  EXPECT_THAT(failures, ElementsAre());
  EXPECT_THAT(files.at("summary.md"),
              AllOf(HasSubstr("### ipopt's\n\n![ipopt](ipopt-ecdf.svg)\nOf 8.\n"),
                    HasSubstr("![nlopt-cobyla](nlopt-cobyla-ecdf.svg)")));
  EXPECT_TRUE(files.contains("nlopt-cobyla-ecdf.svg"));
  EXPECT_TRUE(files.contains("cases.csv"));
  EXPECT_FALSE(files.contains("empty.csv"));
  const std::string& html = files.at("index.html");
  EXPECT_THAT(html, HasSubstr("<div class=\"choices\" data-label=\"Solver\">"));
  EXPECT_THAT(html,
              HasSubstr("<div class=\"choice\" id=\"nlopt-cobyla\" data-title=\"nlopt-cobyla\">"));
  EXPECT_THAT(html, HasSubstr("</div></div>\n<p>End.</p>"));
  EXPECT_THAT(filled_text("{{choose none: Solver}}\n\nText.\n\n{{end}}\n", all), "");
}

TEST(MarkdownPage, RefusesWhatTheResultsDoNotHave) {
  EXPECT_THROW(filled_text("{{unknown}}\n", results()), std::logic_error);
  EXPECT_THROW(filled_text("{{table unknown}}\n", results()), std::logic_error);
  EXPECT_THROW(filled_text("| {{cases.unknown}} |\n", results()), std::logic_error);
  EXPECT_THROW(filled_text("{{fold More}}\n\nText.\n", results()), std::logic_error);
  EXPECT_THROW(page_source("# Title\n"), std::logic_error);
  Results forged = results();
  forged.add("solvers", {"\"><script>", "x", {}});
  EXPECT_THROW(filled_text("{{choose solvers: S}}\n\nText.\n\n{{end}}\n", forged),
               std::logic_error);
}

TEST(MarkdownPage, IsAPageOfSectionsTablesAndPictures) {
  Results many = results();
  ricochet::Table rows{"rows", {{"i"}, {"sign"}}};
  for (int i = 0; i < 20; ++i) rows.add(i, i % 2 == 0 ? "✓ good" : "✗ bad");
  many.add(rows);
  const auto files =
      page_files(page("# Title\n\nIntro.\n\n## One & two\n\n{{chart counts}} Caption.\n\n"
                      "## Rows\n\n{{table rows}}\n\n[away](../count/#there)\n"),
                 many)
          .files;
  const std::string& html = files.at("index.html");
  EXPECT_THAT(html, HasSubstr("<h1>Title</h1>"));
  EXPECT_THAT(html, HasSubstr("<section id=\"one--two\" aria-labelledby=\"one--two-heading\">"));
  EXPECT_THAT(html, HasSubstr("<li><a href=\"#one--two\">One &amp; two</a></li>"));
  EXPECT_THAT(html, HasSubstr("<figcaption>\nCaption.</figcaption>"));
  EXPECT_THAT(html, HasSubstr("<svg class=\"ricochet-chart\""));
  EXPECT_THAT(html, HasSubstr("Show all 20 rows"));
  EXPECT_THAT(html, HasSubstr("class=\"left good\">✓ good"));
  EXPECT_THAT(html, HasSubstr("<a href=\"../count/index.html#there\">away</a>"));
  EXPECT_EQ(html.find("[[picture"), std::string::npos);
  pugi::xml_document tree;
  const std::size_t body = html.find("<main"), end = html.find("</main>");
  EXPECT_TRUE(tree.load_string(html.substr(body, end + 7 - body).c_str()));
}

/// The colours that the style replaces in the dark are those that charts are drawn in.
TEST(MarkdownPage, KnowsTheColoursOfItsCharts) {
  Results two;
  for (const Mark mark : {Mark::line, Mark::points}) {
    Chart chart{.name = mark == Mark::line ? "lines" : "points", .x = {"x"}, .y = {"y"}};
    for (int i = 0; i < 7; ++i)
      chart.series.push_back({std::to_string(i), mark, {{0, 1, Range{0, 2}}, {1, 2, Range{1, 3}}}});
    for (const double at : {0.2, 0.4, 0.6})
      chart.lines.push_back({Direction::vertical, at, std::to_string(at)});
    two.add(chart);
  }
  const auto files = page_files(page("# T\n\n{{chart lines}}\n\n{{chart points}}\n"), two).files;
  const std::string& html = files.at("index.html");
  const std::string svgs = files.at("lines.svg") + files.at("points.svg") +
                           text_of_file(RICOCHET_SOURCE "/docs/machine.svg");
  static const std::regex replaced("figure svg \\[(\\w+=\"[^\"]*\")\\]");
  int colours = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), replaced), end; it != end; ++it) {
    EXPECT_NE(svgs.find((*it)[1].str()), std::string::npos) << (*it)[1];
    ++colours;
  }
  EXPECT_GT(colours, 10);
}

TEST(MarkdownPage, SaysWhyAChartIsMissingAndKeepsAllElse) {
  Results two = results();
  two.add(Chart{.name = "wrong",
                .title = "Wrong <one>",
                .x = {"x"},
                .y = {"y"},
                .series = {{"a", Mark::line, {{0, 1e200}}}}});
  const auto [files, failures] =
      page_files(page("# T\n\n{{chart wrong}} Of it.\n\n{{chart counts}}\n"), two);
  EXPECT_THAT(failures, ElementsAre("chart wrong could not be drawn: series \"a\", sample 0: "
                                    "1e+200 is beyond 1e100"));
  EXPECT_FALSE(files.contains("wrong.svg"));
  EXPECT_THAT(files.at("summary.md"),
              AllOf(HasSubstr("Wrong &lt;one>: series"), HasSubstr("(counts.svg)")));
  EXPECT_THAT(files.at("index.html"),
              AllOf(HasSubstr("Wrong &lt;one&gt;: series"), HasSubstr(files.at("counts.svg"))));
}

TEST(MarkdownPage, HasTheNumbersOfItsChartsAndTheRunsOfAView) {
  Results all = results();
  ricochet::Table runs{"view-runs", {{"a"}, {"b"}}};
  runs.add("</script>", 1);
  all.add(runs);
  const auto files = page_files(page("# T\n\n{{view}}\n\n{{chart counts}}\n"), all).files;
  const std::string& html = files.at("index.html");
  for (const char* part :
       {"class=\"chart-csv\">", "a,1,2\\n", "figure > script.chart-csv", "[\"\\u003c/script>\",1]",
        "id=\"view-form\"", ".view-form {", "class RunTable", "class Choice", "class Chart"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  EXPECT_FALSE(files.contains("view-runs.csv"));
  const auto plain = page_files(page("# T\n\nText.\n"), results()).files.at("index.html");
  EXPECT_THAT(plain, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<link")),
                           Not(HasSubstr("@import")), HasSubstr("<html lang=\"en\">")));
}

TEST(MarkdownPage, NamesTheRowsAndTheCellsOfATable) {
  const std::string html =
      page_files(page("# Title\n\n| a | b | c | d |\n|:--|--:|--:|:--|\n| 1 | 2 | 3 | 4 |\n"),
                 results())
          .files.at("index.html");
  EXPECT_THAT(html,
              HasSubstr("<table class=\"folding\" style=\"--1:&quot;a&quot;;--2:&quot;b&quot;;"
                        "--3:&quot;c&quot;;--4:&quot;d&quot;;\">"));
  EXPECT_THAT(html, HasSubstr("<th class=\"left\" scope=\"row\">1</th>"));
  EXPECT_THAT(page_files(page("# Title\n\n|  | b |\n|:--|--:|\n| 1 | 2 |\n"), results())
                  .files.at("index.html"),
              HasSubstr("<td class=\"left\"></td>"));  // an empty cell heads nothing
}

TEST(MarkdownPage, ComesBackFromItsData) {
  Results before = results();
  Chart map{.name = "map", .title = "Map", .x = {"x"}, .y = {"y"}};
  map.x.categories = {"a", "b"};
  map.y.categories = {"c"};
  map.heat_map = HeatMap{"share", {{0.5, std::nullopt}}, Range{0, 1}, {"view#c"}, {"&a", "&b"}};
  map.lines = {{Direction::vertical, 0.5, "here"}};
  before.add(map);
  Chart areas{
      .name = "areas", .title = "", .x = {"x", Scale::logarithmic, Range{1, 10}}, .y = {"y"}};
  areas.areas = {{"quiet", 0.25, {{{1, {0, 1}}, {2, {0, 3}}}}, "name"}};
  areas.series = {{"", Mark::points, {{1, 2, Range{1, 3}, "dot"}, {2, std::nullopt}}, true, true}};
  areas.description = "Words.";
  before.add(areas);
  Results inner;
  inner.set("share", 1.0 / 3);
  before.add("parts", {"one", "One", inner});
  const Json data = json_of(before);
  EXPECT_EQ(json_of(results_in(Json::parse(json_text(data)))), data);
  const Results after = results_in(data);
  ASSERT_NE(after.chart("map"), nullptr);
  EXPECT_EQ(after.chart("map")->heat_map->row_links, map.heat_map->row_links);
  EXPECT_EQ(after.chart("areas")->series[0].samples[0].name, "dot");
  EXPECT_EQ(after.chart("areas")->areas[0].parts[0][1].between.upper, 3);
  EXPECT_EQ(after.parts.at("parts")[0].results.values[0].second, Value(0.333333));
  EXPECT_EQ(data["values"]["nothing"], nullptr);
}

TEST(MarkdownPage, EndsTheCommand) {
  PageSource source = page("# T\n");
  source.keys["terminal"] = "cases, nothing, empty, speed";
  EXPECT_EQ(terminal_text(source, results()),
            "\n    threshold\nid    [rad/s]\nC1       8.05\nC2\n8.057\n");
}

}  // namespace
}  // namespace ricochet::report
