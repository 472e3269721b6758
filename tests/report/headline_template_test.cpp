#include <gtest/gtest.h>

#include "src/report/page_template.h"

namespace ricochet::report {
namespace {

constexpr const char* headline_sheet = R"(
title = "Of {{name}}"
intro = ["{{finding}} More."]

[headline]
label = "L"
problem = "Q"
command = "C"
finding = "{{name}} is {{size:.1f}}."
made_by = "{{#campaign}}run {{campaign}}{{/campaign}}"
holds = ["entries"]

[[headline.excerpt]]
each = "answers"
topic = "problem"
heading = "{{asked}}"
text = "{{told}}"
links = [{ text = "more", to = "#there" }, { each = "pages", text = "{{.}}", to = "{{.}}" }]

[headline.excerpt.table]
caption = "Rows."
rows = "rows"
most = 1
columns = [
  { title = "a", value = "{{a}}", align = "left", link = "#row" },
  { each = "kinds", title = "{{kind}}", cells = "cells", value = "{{.:.0%}}", link = "{{kind}}" },
]

[[headline.chart]]
name = "work"
title = "Work"
x = { label = "x" }
y = { label = "y", range = [0, "most"] }
series = [
  { label = "all", mark = "points", rows = "rows", x = "a", y = "cost" },
  { label = "none", mark = "points", rows = "nothing", x = "a", y = "cost" },
]
)";

Json headline_data() {
  return {{"name", "it"},
          {"size", 2.25},
          {"campaign", "plan"},
          {"most", 5},
          {"pages", {"count"}},
          {"answers", {{{"asked", "How?"}, {"told", "So."}}}},
          {"kinds", {{{"kind", "one"}}, {{"kind", "two"}}}},
          {"rows",
           {{{"a", 1}, {"cost", 4}, {"cells", {0.5, nullptr}}},
            {{"a", 2}, {"cost", 5}, {"cells", {0.5, 1}}}}},
          {"nothing", Json::array()}};
}

TEST(HeadlineTemplate, SaysWhatWasFoundAndThePageRepeatsIt) {
  const DrawnPage page = drawn(headline_sheet, headline_data());
  EXPECT_EQ(page.headline.version, headline_version);
  EXPECT_EQ(page.headline.title, "Of it");
  EXPECT_EQ(page.headline.finding, "it is 2.2.");
  EXPECT_EQ(page.headline.command, "run plan");
  EXPECT_EQ(page.headline.holds, std::vector<std::string>{"entries"});
  EXPECT_EQ(page.page.intro.at(0), "it is 2.2. More.");
}

TEST(HeadlineTemplate, HasExcerptsWithLinksAndATable) {
  const Headline headline = drawn(headline_sheet, headline_data()).headline;
  ASSERT_EQ(headline.excerpts.size(), 1U);
  const Excerpt& excerpt = headline.excerpts[0];
  EXPECT_EQ(excerpt.heading, "How?");
  ASSERT_EQ(excerpt.links.size(), 2U);
  EXPECT_EQ(excerpt.links[0].to, "#there");
  EXPECT_EQ(excerpt.links[1].to, "count");
  EXPECT_EQ(excerpt.table.caption, "Rows. The first 1 of 2.");
  ASSERT_EQ(excerpt.table.rows.size(), 1U);
  EXPECT_EQ(excerpt.table.rows[0][0].link, "#row");
  EXPECT_EQ(excerpt.table.rows[0][1].text, "50");
  EXPECT_EQ(excerpt.table.rows[0][1].link, "one");
  EXPECT_EQ(excerpt.table.rows[0][2].text, "–");
}

TEST(HeadlineTemplate, LeavesOutSamplesFromTheEndOfTheRangeOnAndEmptySeries) {
  const Headline headline = drawn(headline_sheet, headline_data()).headline;
  ASSERT_EQ(headline.charts.size(), 1U);
  ASSERT_EQ(headline.charts[0].series.size(), 1U);
  ASSERT_EQ(headline.charts[0].series[0].samples.size(), 1U);
  EXPECT_EQ(headline.charts[0].series[0].samples[0].position, 1);
}

TEST(HeadlineTemplate, MakesNoHeadlineWhereThereIsNone) {
  EXPECT_EQ(drawn("title = \"T\"", Json::object()).headline.version, 0);
}

TEST(Headline, IsReadBackFromJson) {
  const Headline headline = headline_in(headline_sheet, headline_data());
  const auto read = Json(headline).get<Headline>();
  EXPECT_EQ(read.version, headline_version);
  EXPECT_EQ(read.finding, headline.finding);
  EXPECT_EQ(read.holds, headline.holds);
}

}  // namespace
}  // namespace ricochet::report
