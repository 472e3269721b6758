#include "src/report/page_template.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

namespace ricochet::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::ThrowsMessage;

Json sample() {
  return {{"total", 2},
          {"absent", nullptr},
          {"cases",
           {{{"id", "C1"},
             {"rows",
              {{{"name", "a, \"b\""}, {"speed", 8.275}, {"good", true}, {"costs", {1.5, nullptr}}},
               {{"name", "c"}, {"speed", nullptr}, {"good", nullptr}, {"costs", {2.0, 3.0}}}}}},
            {{"id", "C2"}, {"rows", Json::array()}}}},
          {"solvers", {{{"name", "x"}}, {{"name", "y"}}}},
          {"charts", {{{"id", "C1"}, {"rows", {{{"time", 1}, {"x", 2.5}}}}}}}};
}

constexpr const char* sheet = R"(
title = "{{total}} cases"
intro = ["First.", "{{#absent}}never{{/absent}}"]
background = ["Why {{total}}."]
epilogue = "{{total}} done"
[[section]]
id = "all"
heading = "All {{total}}"
text = ["Found {{total}}."]
notes = ["How {{total}}."]
[[section.table]]
each = "cases"
rows = "rows"
csv = "rows-{{id}}"
caption = "Of {{id}}"
columns = [
  { title = "name", value = "{{name}}", align = "left" },
  { title = "speed", value = "{{speed:.2f}}", state = "good" },
  { each = "solvers", title = "{{name}}", cells = "costs", value = "{{.:.1f}}" },
]
[[section.chart]]
each = "charts"
name = "case-{{id}}"
title = "Case {{id}}"
caption = "{{id}} of {{total}}"
choice = "choose {{id}}"
x = { label = "time [s]" }
y = { label = "x [mm]" }
series = [{ rows = "rows", x = "time", y = "x" }]
[[section]]
when = "absent"
id = "never"
heading = "Never"
)";

TEST(PageTemplate, TakesTheDataOfAViewAsTheyAre) {
  const Json data = {{"table", {{"runs", {1, 2}}}}};
  const auto drawing = drawn(
      "title = \"T\"\n[[section]]\nid = \"a\"\nheading = \"A\"\nview = \"table\"\n"
      "[[section]]\nid = \"b\"\nheading = \"B\"\n",
      data, Mismatch::throws);
  EXPECT_EQ(drawing.page.sections.at(0).view, data["table"]);
  EXPECT_TRUE(drawing.page.sections.at(1).view.is_null());
}

TEST(PageTemplate, MakesAPageOfData) {
  const DrawnPage drawing = drawn(sheet, sample());
  EXPECT_EQ(drawing.page.title, "2 cases");
  EXPECT_THAT(drawing.page.intro, ElementsAre("First."));
  EXPECT_EQ(drawing.epilogue, "2 done");
  ASSERT_EQ(drawing.page.sections.size(), 1u);
  const Section& section = drawing.page.sections.front();
  EXPECT_EQ(section.heading, "All 2");
  EXPECT_THAT(section.paragraphs, ElementsAre("Found 2."));
  EXPECT_THAT(section.notes, ElementsAre("How 2."));
  EXPECT_THAT(drawing.page.background, ElementsAre("Why 2."));
  ASSERT_EQ(section.tables.size(), 2u);
  EXPECT_EQ(section.tables[0].caption, "Of C1");
  EXPECT_EQ(section.tables[1].rows.size(), 0u);
}

TEST(PageTemplate, MakesTheCellsOfATable) {
  const DrawnPage drawing = drawn(sheet, sample());
  const Table& table = drawing.page.sections.front().tables.front();
  std::vector<std::string> titles;
  for (const Column& column : table.columns) titles.push_back(column.title);
  EXPECT_THAT(titles, ElementsAre("name", "speed", "x", "y"));
  ASSERT_EQ(table.rows.size(), 2u);
  std::vector<std::string> texts;
  for (const auto& row : table.rows) {
    for (const Cell& cell : row) texts.push_back(cell.text);
  }
  EXPECT_THAT(texts, ElementsAre("a, \"b\"", "8.28", "1.5", "–", "c", "–", "2.0", "3.0"));
  EXPECT_EQ(table.rows[0][1].state, State::good);
  EXPECT_EQ(table.rows[1][1].state, State::neutral);
}

TEST(PageTemplate, KeepsTheRowsOfATableWithAllTheirDigits) {
  EXPECT_THAT(drawn(sheet, sample()).tables, ElementsAre(Pair("rows-C1.csv",
                                                              "name,speed,good,costs.0,costs.1\n"
                                                              "\"a, \"\"b\"\"\",8.275,true,1.5,\n"
                                                              "c,,,2.0,3.0\n"),
                                                         Pair("rows-C2.csv", "\n")));
}

TEST(PageTemplate, KeepsNoNameOfARowThatIsAFormula) {
  Json data = sample();
  data["cases"][0]["rows"][1]["=cmd|x"] = "@SUM(1)";
  const std::string table = drawn(sheet, data).tables.at("rows-C1.csv");
  EXPECT_THAT(table, HasSubstr(",'=cmd|x\n"));
  EXPECT_THAT(table, HasSubstr(",'@SUM(1)\n"));
}

TEST(PageTemplate, KeepsNoLabelThatIsReadAsAMissingValue) {
  Json data = sample();
  data["cases"][0]["rows"][1]["perturbation"] = "nan";
  EXPECT_THAT(drawn(sheet, data).tables.at("rows-C1.csv"), HasSubstr(",missing-value\n"));
}

TEST(PageTemplate, KeepsTheRowsOfATableInItsFolderOnly) {
  for (const char* id : {"/../../C1", "a b", "\x1b[31m"}) {
    Json data = sample();
    data["cases"][0]["id"] = id;
    EXPECT_THROW(drawn(sheet, data), std::logic_error) << id;
  }
}

TEST(PageTemplate, ShowsTheFirstRowsOfALongTableAndSaysWhereAllAre) {
  std::string shortened = sheet;
  shortened.insert(shortened.find("caption = \"Of"), "most = 1\n");
  const DrawnPage result = drawn(shortened, sample());
  const Table& table = result.page.sections[0].tables[0];
  EXPECT_EQ(table.rows.size(), 1);
  EXPECT_EQ(table.caption, "Of C1 The first 1 of 2; all are in rows-C1.csv.");
  EXPECT_EQ(result.page.sections[0].tables[1].caption, "Of C2") << "all are shown";
  EXPECT_EQ(result.tables, drawn(sheet, sample()).tables);
}

TEST(PageTemplate, MakesTheChartsWithTheirWords) {
  const DrawnPage drawing = drawn(sheet, sample());
  const auto& figures = drawing.page.sections.front().figures;
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].chart.title, "Case C1");
  EXPECT_EQ(figures[0].caption, "C1 of 2");
  EXPECT_EQ(figures[0].choice, "choose C1");
  EXPECT_EQ(figures[0].chart.series[0].samples.at(0).value, 2.5);
}

TEST(PageTemplate, RepeatsAParagraphForEveryEntryOfAList) {
  const std::string text = R"(
title = ""
[[section]]
id = "all"
heading = "All"
text = ["First.", { each = "cases", text = "Of {{id}}." }, { when = "absent", text = "Never." }])";
  EXPECT_THAT(drawn(text, sample()).page.sections.front().paragraphs,
              ElementsAre("First.", "Of C1.", "Of C2."));
}

TEST(PageTemplate, TakesRowsThatAreWrittenOut) {
  const std::string text = R"(
title = ""
[[section]]
id = "all"
heading = "All"
[[section.table]]
caption = "Decisions"
columns = [{ title = "paper", align = "left" }, { title = "here" }]
rows = [["a", "b of {{total}}"], ["c", "d"]])";
  const DrawnPage drawing = drawn(text, sample());
  const Table& table = drawing.page.sections.front().tables.front();
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][1].text, "b of 2");
  EXPECT_EQ(table.rows[1][0].text, "c");
  EXPECT_TRUE(drawing.tables.empty()) << "no csv is asked for";
}

TEST(PageTemplate, LooksNamesUpInTheDataOfAPart) {
  const std::string text = R"(
title = ""
[[section]]
each = "cases"
data = "texts.{{id}}"
id = "of-{{id}}"
heading = "{{words}}")";
  Json data = sample();
  data["texts"] = {{"C1", {{"words", "One"}}}, {"C2", {{"words", "Two"}}}};
  const auto sections = drawn(text, data).page.sections;
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[1].id, "of-C2");
  EXPECT_EQ(sections[1].heading, "Two");
}

TEST(PageTemplate, RefusesWhatTheDataDoNotHave) {
  Json data = sample();
  data.erase("solvers");
  EXPECT_THAT([&] { drawn(sheet, data); }, ThrowsMessage<std::logic_error>(HasSubstr("solvers")));
}

TEST(PageTemplate, LetsChartsThatDoNotFitCostThemselvesAlone) {
  const char* const text = R"(
title = "t"
[[section]]
id = "s"
heading = "h"
[[section.chart]]
each = "cases"
name = "of-{{id}}"
title = "t"
x.label = "x"
y.label = "y"
series = [{label = "a", rows = "points", x = "speed", y = "speed"}]
)";
  Json data = sample();
  data["cases"][1]["points"] = {{{"speed", 3}}};
  EXPECT_THROW(drawn(text, data), std::logic_error);
  const auto figures = drawn(text, data, Mismatch::costs_its_chart).page.sections.at(0).figures;
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].chart.name, "of-c1");
  EXPECT_THAT(figures[0].failure, HasSubstr("points"));
  EXPECT_EQ(figures[1].failure, "");
  EXPECT_EQ(figures[1].chart.series.at(0).samples.size(), 1U);
}

TEST(PageTemplate, SaysHowManyDigitsAreKept) {
  EXPECT_TRUE(kept_digits("title = \"t\"").empty());
  EXPECT_EQ(kept_digits("[digits]\nshare = 4\nspeed = 17"), (Digits{{"share", 4}, {"speed", 17}}));
}

}  // namespace
}  // namespace ricochet::report
