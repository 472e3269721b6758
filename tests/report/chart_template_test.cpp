#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "src/report/page_template.h"

namespace ricochet::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;
using testing::ThrowsMessage;

const Json data = {
    {"id", "C2"},
    {"unit", "rad/s"},
    {"tried", false},
    {"fastest", 18.5},
    {"unknown", nullptr},
    {"rows",
     {{{"speed", 3}, {"share", 0.5}, {"error", -2.0}, {"known", true}},
      {{"speed", 1}, {"share", 0.25}, {"error", 0.0}, {"known", false}},
      {{"speed", 2}, {"share", nullptr}, {"error", 4.0}, {"known", true}}}},
    {"more", {{{"speed", 4}, {"share", 1}}}},
    {"solvers",
     {{{"name", "one"}, {"runs", {1.5, nullptr}}}, {{"name", "two"}, {"runs", {2.5, 3.5}}}}},
    {"cases", {"C1", "C2"}}};

/// A chart of two plain axes, with what is added.
Chart made(const std::string& added) {
  const toml::table table = toml::parse(R"(
name = "Chart of_{{id}}"
title = "Of {{id}}"
)" + added);
  return chart_of(TemplatePart(table), {&data});
}

Chart with_series(const std::string& series, const std::string& scale = "linear") {
  return made("x = { label = \"a\" }\ny = { label = \"b\", scale = \"" + scale +
              "\" }\nseries = [{ label = \"s\", " + series + " }]");
}

std::vector<double> positions(const Series& series) {
  std::vector<double> all;
  for (const Sample& sample : series.samples) all.push_back(sample.position);
  return all;
}

std::vector<std::optional<double>> values(const Series& series) {
  std::vector<std::optional<double>> all;
  for (const Sample& sample : series.samples) all.push_back(sample.value);
  return all;
}

TEST(ChartTemplate, BeginsASeriesAtItsStart) {
  const Series series =
      with_series("mark = \"steps\", rows = \"rows\", x = \"speed\", y = \"share:%\", start = 0")
          .series.at(0);
  EXPECT_THAT(positions(series), ElementsAre(1, 1, 2, 3));
  EXPECT_THAT(values(series).front(), Optional(0.0));
  EXPECT_THAT(values(series).at(1), Optional(25.0));
}

TEST(ChartTemplate, FillsInTextsAndNumbers) {
  const Chart chart = made(R"(
width = 700
height = 100
x = { label = "speed [{{unit}}]", range = [0, "fastest"] }
y = { label = "b", scale = "{{#tried}}linear{{/tried}}{{^tried}}logarithmic{{/tried}}", range = ["unknown", 1] }
lines = [
  { vertical = "fastest", label = "of {{id}}" },
  { vertical = "unknown", label = "unknown" },
  { horizontal = 2, label = "two" },
  { when = "^tried", each = "rows", horizontal = "speed", label = "each" },
]
description = "Words for {{id}}.")");
  EXPECT_EQ(chart.name, "chart-of-c2");
  EXPECT_EQ(chart.title, "Of C2");
  EXPECT_EQ(chart.width, 700);
  EXPECT_EQ(chart.height, 100);
  EXPECT_EQ(chart.x.label, "speed [rad/s]");
  EXPECT_EQ(chart.x.range->upper, 18.5);
  EXPECT_EQ(chart.y.scale, Scale::logarithmic);
  EXPECT_FALSE(chart.y.range.has_value());
  ASSERT_EQ(chart.lines.size(), 5U);
  EXPECT_EQ(chart.lines[0].direction, Direction::vertical);
  EXPECT_EQ(chart.lines[0].position, 18.5);
  EXPECT_EQ(chart.lines[0].label, "of C2");
  EXPECT_EQ(chart.lines[1].direction, Direction::horizontal);
  EXPECT_EQ(chart.lines[4].position, 2);
  EXPECT_EQ(chart.description, "Words for C2.");
}

TEST(ChartTemplate, PutsALineInOrderAndLeavesPointsAsTheyAre) {
  const Series line = with_series("rows = 'rows', x = 'speed', y = 'share:%'").series.at(0);
  EXPECT_EQ(line.label, "s");
  EXPECT_THAT(positions(line), ElementsAre(1, 2, 3));
  EXPECT_THAT(values(line), ElementsAre(Optional(25.0), std::nullopt, Optional(50.0)));
  const Series points =
      with_series("mark = 'points', rows = ['rows', 'more'], x = 'speed', y = 'share'").series[0];
  EXPECT_THAT(positions(points), ElementsAre(3, 1, 2, 4));
}

TEST(ChartTemplate, TakesTheRowsOfWhichAConditionHolds) {
  EXPECT_THAT(positions(with_series("rows = 'rows', where = 'known', y = 'speed'").series[0]),
              ElementsAre(0, 2));
  EXPECT_THAT(positions(with_series("rows = 'rows', where = '^known', y = 'speed'").series[0]),
              ElementsAre(1));
}

TEST(ChartTemplate, HasAGapWhereALogarithmicAxisHasNoPlace) {
  const Series series =
      with_series("rows = 'rows', x = 'speed', y = 'error'", "logarithmic").series[0];
  EXPECT_THAT(values(series), ElementsAre(std::nullopt, Optional(4.0), std::nullopt));
  const Series sizes =
      with_series("rows = 'rows', x = 'speed', y = 'error:size'", "logarithmic").series[0];
  EXPECT_THAT(values(sizes), ElementsAre(std::nullopt, Optional(4.0), Optional(2.0)));
}

TEST(ChartTemplate, BoundsTheSpreadWhereBothEndsAreKnown) {
  const Series series =
      with_series("rows = 'rows', x = 'speed', y = 'speed', lower = 'share', upper = 'fastest'")
          .series[0];
  ASSERT_TRUE(series.samples[0].spread.has_value());
  EXPECT_EQ(series.samples[0].spread->lower, 0.25);
  EXPECT_EQ(series.samples[0].spread->upper, 18.5);
  EXPECT_FALSE(series.samples[1].spread.has_value());
}

TEST(ChartTemplate, RepeatsASeriesAndTakesSamplesThatAreWrittenOut) {
  const Chart chart = made(R"(
x = { label = "a" }
y = { label = "b" }
series = [
  { each = "solvers", label = "{{name}} of {{id}}", rows = "runs", y = "." },
  { when = "tried", label = "never", rows = "rows", y = "speed" },
  { label = "limit", mark = "steps", samples = [[0, 1.5], ["fastest", "unknown"]] },
])");
  ASSERT_EQ(chart.series.size(), 3U);
  EXPECT_EQ(chart.series[1].label, "two of C2");
  EXPECT_THAT(values(chart.series[1]), ElementsAre(Optional(2.5), Optional(3.5)));
  EXPECT_EQ(chart.series[2].mark, Mark::steps);
  EXPECT_THAT(positions(chart.series[2]), ElementsAre(0, 18.5));
  EXPECT_THAT(values(chart.series[2]), ElementsAre(Optional(1.5), std::nullopt));
}

TEST(ChartTemplate, MakesAHeatMapOfTheEntriesOfItsAxes) {
  const std::string map = R"(
height = 120
row_height = 20
x = { label = "case", categories = "cases" }
heat_map = { label = "runs [%]", cells = "runs", value = ".:%", range = [0, 400] }
y = { label = "solver", categories = "solvers", category = "{{name}}")";
  const Chart up = made(map + " }");
  check(up);
  EXPECT_THAT(up.x.categories, ElementsAre("C1", "C2"));
  EXPECT_THAT(up.y.categories, ElementsAre("one", "two"));
  EXPECT_THAT(up.heat_map->rows.at(0), ElementsAre(Optional(150.0), std::nullopt));
  EXPECT_EQ(up.heat_map->range->upper, 400);
  EXPECT_EQ(up.height, 160);
  const Chart down = made(map + ", order = 'down' }");
  EXPECT_THAT(down.y.categories, ElementsAre("two", "one"));
  EXPECT_THAT(down.heat_map->rows.at(1), ElementsAre(Optional(150.0), std::nullopt));
}

TEST(ChartTemplate, LeavesOutNumbersThatAreNotFinite) {
  const Json rows = {{"rows", {1.0, std::numeric_limits<double>::infinity()}}};
  const toml::table table = toml::parse(R"(
name = "a"
title = "b"
x = { label = "a" }
y = { label = "b" }
series = [{ rows = "rows", y = "." }])");
  EXPECT_THAT(values(chart_of(TemplatePart(table), {&rows}).series[0]),
              ElementsAre(Optional(1.0), std::nullopt));
}

TEST(ChartTemplate, RefusesWhatItDoesNotKnow) {
  const auto refuses = [](const std::string& series, const std::string& why) {
    EXPECT_THAT([&] { with_series(series); }, ThrowsMessage<std::logic_error>(HasSubstr(why)));
  };
  refuses("rows = 'rows', y = 'share', mark = 'dots'", "mark cannot be dots");
  refuses("rows = 'rows', y = 'nothing'", "nothing");
  refuses("rows = 'rows', y = 'known'", "known is no number");
  refuses("rows = 'rows', y = 'share:mm'", "share:mm");
  EXPECT_THAT([] { made("x = { label = 'a' }"); },
              ThrowsMessage<std::logic_error>(HasSubstr("y must be a table")));
}

TEST(ChartTemplate, MakesAreasOfTheirEdges) {
  const Json maps = {{"regions",
                      {{{"label", "few"}, {"shade", 0.5}, {"parts", {{{0, 1, 2}, {1, 1, 3}}}}},
                       {{"label", "none"}, {"shade", nullptr}, {"parts", Json::array()}}}}};
  const toml::table table = toml::parse(R"(
name = "map"
title = "Map"
x = { label = "x" }
y = { label = "y" }
areas = [{ each = "regions", label = "{{label}}", name = "{{label}}", shade = "shade", parts = "parts" }]
)");
  const Chart chart = chart_of(TemplatePart(table), {&maps});
  ASSERT_EQ(chart.areas.size(), 2U);
  EXPECT_EQ(chart.areas[0].name, "few");
  EXPECT_EQ(chart.areas[0].shade, 0.5);
  ASSERT_EQ(chart.areas[0].parts.size(), 1U);
  EXPECT_EQ(chart.areas[0].parts[0][1].position, 1);
  EXPECT_EQ(chart.areas[0].parts[0][1].between.upper, 3);
  EXPECT_EQ(chart.areas[1].shade, std::nullopt);
}

TEST(ChartTemplate, KeepsTheOrderOfLinesWithGaps) {
  const Json lines = {{"samples",
                       {{{"x", 1}, {"y", 1}},
                        {{"x", 2}, {"y", 2}},
                        {{"x", 2}, {"y", nullptr}},
                        {{"x", 0}, {"y", 3}}}}};
  const toml::table table = toml::parse(R"(
name = "map"
title = "Map"
x = { label = "x" }
y = { label = "y" }
series = [{ label = "", look = "dark", order = "given", rows = "samples", x = "x", y = "y" }]
)");
  const Chart chart = chart_of(TemplatePart(table), {&lines});
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_TRUE(chart.series[0].dark);
  EXPECT_EQ(chart.series[0].samples.at(3).position, 0);
  EXPECT_NO_THROW(check(chart));
}

}  // namespace
}  // namespace ricochet::report
