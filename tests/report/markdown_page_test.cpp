#include "src/report/markdown_page.h"

#include <regex>

#include "src/report/markdown_html.h"
#include "src/report/text.h"
#include "tests/report/pictures.h"
#include "tests/support/files.h"
#include "tests/support/golden.h"
#include "tests/support/refusals.h"

namespace ricochet::report {
namespace {

PageSource page(const std::string& text) {
  return page_source("---\ngroup: Machine\n---\n" + text);
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
  results.add(changed(line_chart({{0, 1}, {1, 2}}), [](Chart& chart) {
    chart.name = "counts", chart.title = "Counts <rise>", chart.series[0].label = "a";
  }));
  return results;
}

std::string filled(const std::string& text) {
  return filled_page(page(text), results());
}

FileSet files_of(const std::string& text, const Results& results) {
  return page_files(page(text), results).files;
}

TEST(MarkdownPage, FillsInValues) {
  EXPECT_EQ(filled("At {{speed:.1f}} rad/s.\n"), "At 8.1 rad/s.\n");
  EXPECT_EQ(filled("Of {{name}}\n"), "Of a\\|b\\_&lt;c>\n");
  EXPECT_EQ(filled("`run {{name}}`\n"), "`run a|b_<c>`\n");
  EXPECT_EQ(filled("```\n{{name}}\n\n{{speed:.0f}}\n```\n"), "```\na|b_<c>\n\n8\n```\n");
}

TEST(MarkdownPage, LeavesOutWhatHasNoValuesAndHeadingsAboveNothing) {
  EXPECT_EQ(filled("One.\n\nNo {{nothing}}\nat all.\n\nTwo.\n"), "One.\n\nTwo.\n");
  EXPECT_EQ(filled("# Page\n\n## A\n\n{{nothing}}\n\n### B\n\n{{table empty}}\n\n## C\n\nText.\n"),
            "# Page\n\n## C\n\nText.\n");
  EXPECT_EQ(filled("- one\n- {{nothing}}\n- three\n"), "- one\n- three\n");
  EXPECT_EQ(filled("{{fold More}}\n\n{{nothing}}\n\n{{end}}\n\nText.\n"), "Text.\n");
  EXPECT_EQ(filled("{{choose none: Solver}}\n\nText.\n\n{{end}}\n"), "");
  EXPECT_EQ(filled("| id |\n|--|\n| {{empty.id}} |\n"), "");
  EXPECT_EQ(filled("# P\n\n## A\n\nWords.\n\n{{table empty}}\n\n### B\n\nMore.\n\n## C\n\nEnd.\n"),
            "# P\n\n## C\n\nEnd.\n")
      << "a section that has nothing of what it asks for";
  EXPECT_EQ(filled("## A\n\nWords.\n\n{{table empty}}\n\nAt {{speed:.0f}}.\n"),
            "## A\n\nWords.\n\nAt 8.\n");
}

TEST(MarkdownPage, ShowsTablesAndRepeatsALineForEachRow) {
  const std::string rest = "\nThe first 1 of 2 rows; all are in `cases.csv`.\n";
  const std::string head = "| id | threshold [rad/s] |\n|:--|--:|\n| C1 | 8.05 |\n";
  EXPECT_EQ(filled("{{table cases}}\n"), head + "| C2 |  |\n");
  EXPECT_EQ(filled("{{table cases 1}}\n"), head + rest);
  EXPECT_EQ(filled("{{rows 1}}\n| case |\n|:--|\n| {{cases.id}} |\n"),
            "| case |\n|:--|\n| C1 |\n" + rest);
  EXPECT_EQ(filled("| case | speed |\n|:--|--:|\n| [{{cases.id}}]({{cases.id}}/) | "
                   "{{cases.threshold:.1f}} rad/s |\n"),
            "| case | speed |\n|:--|--:|\n| [C1](C1/summary.md) | 8.1 rad/s |\n| "
            "[C2](C2/summary.md) | |\n");
  EXPECT_EQ(filled("- {{cases.id}}: {{cases.threshold}}\n"), "- C1: 8.05\n");
}

TEST(MarkdownPage, RefusesWhatTheResultsDoNotHave) {
  Results all = results();
  all.add("solvers", {"\"><script>", "x", {}});
  expect_refusals<std::logic_error>(
      [&](const std::string& text) { return filled_page(page(text), all); },
      {{"{{unknown}}\n", "unknown"},
       {"{{table unknown}}\n", "unknown"},
       {"| {{cases.unknown}} |\n", "unknown"},
       {"{{fold More}}\n\nText.\n", "fold"},
       {"{{choose solvers: S}}\n\nText.\n\n{{end}}\n", "\"><script>"}});
  EXPECT_THROW(page_source("# Title\n"), std::logic_error);
}

/// What of a page is its own, without the SVG of its pictures.
std::string own_html(const std::string& html) {
  const std::size_t begin = html.find("<header>"), end = html.find("</main>") + 7;
  static const std::regex picture("<svg class=\"ricochet-chart\"[^]*?</svg>");
  return std::regex_replace(html.substr(begin, end - begin), picture, "<svg/>") + "</div>\n";
}

/// All that a page may have.
TEST(MarkdownPage, IsAPageOfSectionsTablesAndPictures) {
  Results all = results();
  ricochet::Table rows{"rows", {{"i"}, {"sign"}}};
  for (int i = 0; i < 13; ++i) rows.add(i, i % 2 == 0 ? "✓ good" : "✗ bad");
  all.add(rows);
  for (const char* id : {"ipopt", "nlopt-cobyla"}) {
    Results own;
    own.set("kind", std::string(id) + "'s");
    own.add(Chart{.name = "ecdf", .title = id, .x = {"x"}, .y = {"y"}});
    all.add("solvers", {id, id, own});
  }
  const auto [files, failures] = page_files(
      page("# Title\n\nIntro.\n\n## One & two\n\n{{chart counts}} Caption.\n\n"
           "## Rows\n\n{{table rows}}\n\n[away](../count/#there)\n\n"
           "| a | b < c | the \"best\" | f; |\n|:--|--:|--:|:--|\n| 1 | 2 | 3 | 4 |\n\n"
           "|  | b |\n|:--|--:|\n| 1 < 2 | `x` |\n\n```console\n$ run\n\n$ stop\n```\n\n"
           "## Solvers\n\n{{choose solvers: Solver}}\n\n### {{kind}}\n\n"
           "{{chart ecdf}} Of {{speed:.0f}}.\n\n{{end}}\n\n{{fold More}}\n\nFolded.\n\n{{end}}\n\n"
           "End.\n"),
      all);
  EXPECT_THAT(failures, ElementsAre());
  using testing::Key;
  EXPECT_THAT(files, ElementsAre(Key("cases.csv"), Key("counts.svg"), Key("index.html"),
                                 Key("ipopt-ecdf.svg"), Key("nlopt-cobyla-ecdf.svg"),
                                 Key("rows.csv"), Key("summary.md")))
      << "an empty table has no file";
  expect_golden(files.at("summary.md"), "page.md");
  const std::string& html = files.at("index.html");
  expect_golden(own_html(html), "page.html");
  EXPECT_THAT(html, AllOf(HasSubstr(files.at("counts.svg")), HasSubstr("<html lang=\"en\">")));
  EXPECT_TRUE(pugi::xml_document().load_string(own_html(html).c_str()));
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
  const FileSet files = files_of("# T\n\n{{chart lines}}\n\n{{chart points}}\n", two);
  const std::string& html = files.at("index.html");
  const std::string svgs = files.at("lines.svg") + files.at("points.svg") +
                           text_of(fs::path(RICOCHET_SOURCE "/docs/machine.svg"));
  static const std::regex replaced("figure svg \\[(\\w+=\"[^\"]*\")\\]");
  int colours = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), replaced), end; it != end; ++it) {
    EXPECT_THAT(svgs, HasSubstr((*it)[1].str()));
    ++colours;
  }
  EXPECT_GT(colours, 10);
}

TEST(MarkdownPage, HasTheNumbersOfItsChartsAndTheRunsOfAView) {
  Results all = results();
  ricochet::Table runs{"view-runs", {{"a"}, {"b"}}};
  runs.add("</script>", 1);
  all.add(runs);
  const FileSet files = files_of("# T\n\n{{view}}\n\n{{chart counts}}\n", all);
  for (const char* part :
       {"class=\"chart-csv\">", "a,1,2\\n", "figure > script.chart-csv", "[\"\\u003c/script>\",1]",
        "id=\"view-form\"", ".view-form {", "class RunTable", "class Choice", "class Chart"}) {
    EXPECT_THAT(files.at("index.html"), HasSubstr(part));
  }
  EXPECT_FALSE(files.contains("view-runs.csv"));
  EXPECT_THAT(files_of("# T\n\nText.\n", results()).at("index.html"),
              AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<link")), Not(HasSubstr("@import"))));
}

TEST(MarkdownPage, ComesBackFromItsData) {
  Results before = results();
  Chart map{.name = "map",
            .title = "Map",
            .x = {.label = "x", .categories = {"a", "b"}},
            .y = {.label = "y", .categories = {"c"}}};
  map.heat_map = HeatMap{"share", {{0.5, std::nullopt}}, Range{0, 1}, {"view#c"}, {"&a", "&b"}};
  map.lines = {{Direction::vertical, 0.5, "here"}};
  before.add(map);
  Chart areas{.name = "areas", .x = {"x", Scale::logarithmic, Range{1, 10}}, .y = {"y"}};
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

HtmlPage converted(const std::string& markdown) {
  const auto target = [](const std::string& link) { return link == "no" ? "" : "to/" + link; };
  return html_page(markdown, {.target = target});
}

TEST(Markdown, HasAnchorsAsCodeHostsMakeThem) {
  const HtmlPage document =
      converted("# What it *is*: 3 of 4\n\nFirst.\n\n## A `b_c` d\n\nSecond.\n");
  EXPECT_EQ(document.title, "What it is: 3 of 4");
  EXPECT_THAT(document.html, HasSubstr("<section id=\"a-b_c-d\""));
  ASSERT_EQ(document.parts.size(), 2U);
  EXPECT_EQ(document.parts[1].anchor, "a-b_c-d");
  EXPECT_THAT(document.parts[1].text, HasSubstr("Second."));
  EXPECT_THAT(document.parts[0].text, Not(HasSubstr("Second.")));
}

TEST(Markdown, LeadsLinksAndPicturesWhereTheSiteHasThemAndDropsComments) {
  EXPECT_THAT(
      converted("[one](a.md) [two](no) ![three](b.svg) ![four](no)\n\n<!-- not run: long -->").html,
      AllOf(HasSubstr("<a href=\"to/a.md\">one</a>"), HasSubstr("<span>two</span>"),
            HasSubstr("<img src=\"to/b.svg\" alt=\"three\">"), HasSubstr("<span>four</span>"),
            Not(HasSubstr("not run"))));
}

}  // namespace
}  // namespace ricochet::report
