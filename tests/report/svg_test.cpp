#include "src/report/svg.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>

#include "src/report/drawing.h"
#include "src/report/frame.h"
#include "src/report/painted.h"
#include "tests/report/read_svg.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* first_colour = "#0072b2";

std::string text_of(const Chart& chart) {
  return ReadSvg(to_svg(chart)).text();
}

/// One of every kind.
std::vector<Chart> gallery() {
  Chart steps = line_chart({{1, 1, Range{0.5, 2}}, {10, 5, Range{4, 6}}, {100, {}}, {1000, 7}});
  steps.name = "steps";
  steps.series[0].mark = Mark::steps;
  steps.x.scale = Scale::logarithmic;
  steps.lines = {{Direction::vertical, 9, "paper"}, {Direction::horizontal, 3, "wall"}};
  Chart names = line_chart({{0, 3}, {1, {}}});
  names.name = "names";
  names.series[0].mark = Mark::points;
  names.x.categories = {"first", "second"};
  Chart many = line_chart({{0, 1}, {1, 2}});
  many.name = "many";
  for (int i = 0; i < 11; ++i)
    many.series.push_back({"solver " + std::to_string(i), Mark::points, {{0.5, 1.0 + i}}});
  Chart areas = line_chart({{0, 1}, {4, 5}});
  areas.name = "areas";
  areas.series[0].dark = true;
  areas.areas = {{"few", 0.5, {{{0, {0, 1}}, {4, {0, 5}}}}, "two"},
                 {"irregular", std::nullopt, {{{0, {1, 6}}, {4, {5, 6}}}}, {}}};
  return {line_chart({{0, 1}, {1, 2}}),       steps, names, many, areas,
          heat_map_chart({{1.5, 2}, {{}, 4}})};
}

TEST(Svg, IsWellFormedForEveryKindOfChart) {
  for (const Chart& chart : gallery()) {
    const std::string svg = to_svg(chart);
    EXPECT_NO_THROW(ReadSvg{svg});
    EXPECT_THAT(svg, AllOf(testing::StartsWith("<svg class=\"ricochet-chart\""),
                           HasSubstr("role=\"img\""), Not(HasSubstr("<script"))));
  }
}

TEST(Svg, HasTheSameBytesEveryTime) {
  for (const Chart& chart : gallery()) EXPECT_EQ(to_svg(chart), to_svg(chart));
}

TEST(Svg, GivesEveryIdOfEveryChartAName) {
  std::set<std::string> all;
  for (const Chart& chart : gallery()) {
    const std::vector<std::string> found = ReadSvg(to_svg(chart)).ids();
    EXPECT_GE(found.size(), 2U);
    for (const std::string& id : found) EXPECT_TRUE(all.insert(id).second) << id;
  }
}

TEST(Svg, PointsOnlyToIdsThatExist) {
  static const std::regex pattern("url\\(#([^\")]*)");
  int references = 0;
  for (const Chart& chart : gallery()) {
    const std::string svg = to_svg(chart);
    const std::vector<std::string> found = ReadSvg(svg).ids();
    for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it) {
      EXPECT_THAT(found, testing::Contains((*it)[1].str()));
      ++references;
    }
  }
  EXPECT_GT(references, 5);
}

TEST(Svg, IsStackedOnAnother) {
  const Chart above = gallery()[0], below = gallery()[1];
  EXPECT_EQ(stacked({to_svg(above)}), to_svg(above));
  const ReadSvg both(stacked({to_svg(above), to_svg(below)}));
  EXPECT_EQ(both.root().attribute("height").as_int(), above.height + below.height);
  EXPECT_EQ(both.root().child("svg").attribute("y").as_int(), 0);
  EXPECT_EQ(both.root().last_child().attribute("y").as_int(), above.height);
  EXPECT_EQ(both.text(), text_of(above) + text_of(below));
}

TEST(Svg, PutsValuesWhereTheAxesSay) {
  Chart chart = line_chart({{0, 0}, {10, 100}});
  chart.x.range = Range{0, 10};
  chart.y.range = Range{0, 100};
  const Box plot = frame_of(chart).plot;
  const auto paths = ReadSvg(to_svg(chart)).paths("stroke", first_colour);
  ASSERT_EQ(paths.size(), 1U);
  const auto& line = paths[0].lines.at(0);
  ASSERT_EQ(line.size(), 2U);
  EXPECT_NEAR(line[0].x, plot.left, 0.1);
  EXPECT_NEAR(line[0].y, plot.bottom, 0.1);
  EXPECT_NEAR(line[1].x, plot.right, 0.1);
  EXPECT_NEAR(line[1].y, plot.top, 0.1);
}

TEST(Svg, PutsDecadesOfALogarithmicAxisAtEqualDistances) {
  Chart chart = line_chart({});
  chart.x.scale = Scale::logarithmic;
  chart.x.range = Range{1, 100};
  chart.series[0].mark = Mark::points;
  chart.series[0].samples = {{1, 1}, {10, 1}, {100, 1}};
  const Box plot = frame_of(chart).plot;
  const auto paths = ReadSvg(to_svg(chart)).paths("stroke", first_colour);
  ASSERT_EQ(paths.size(), 1U);
  ASSERT_EQ(paths[0].lines.size(), 3U);
  EXPECT_NEAR(paths[0].lines[1][0].x, (plot.left + plot.right) / 2, 0.1);
}

TEST(Svg, EndsLinesAndBandsAtTheEdgeOfThePlot) {
  Chart chart = line_chart({{0, 0, Range{-1, 1}}, {10, 100, Range{90, 110}}});
  chart.y.range = Range{0, 50};
  const ReadSvg svg(to_svg(chart));
  EXPECT_EQ(svg.paths("stroke", first_colour).size(), 1U);
  EXPECT_EQ(svg.paths("fill", first_colour).size(), 1U);
  EXPECT_EQ(svg.paths("clip-path", "url(#chart-plot)").size(), 2U);
  const Box plot = frame_of(chart).plot;
  const pugi::xml_node clip = svg.root().child("clipPath").child("rect");
  EXPECT_NEAR(clip.attribute("y").as_double(), plot.top - 2, 0.6);
  EXPECT_NEAR(clip.attribute("height").as_double(), plot.height() + 4, 0.6);
}

TEST(Svg, DrawsReferenceLinesAcrossThePlotAndNamesThem) {
  Chart chart = line_chart({{1, 1}, {2, 2}});
  chart.x.range = chart.y.range = Range{1.0 / 3, 20.0 / 3};
  chart.lines = {{Direction::horizontal, 1, "one"}, {Direction::vertical, 2, "two"}};
  const ReadSvg svg(to_svg(chart));
  const Box plot = frame_of(chart).plot;
  for (const char* colour : {"#222222", "#bf8600"}) {
    EXPECT_EQ(svg.lines_of("stroke", colour), 2U) << colour;  // and in the legend
  }
  const auto line = svg.paths("stroke", "#222222")[0].lines[0];
  EXPECT_NEAR(line.front().x, plot.left, 0.1);
  EXPECT_NEAR(line.back().x, plot.right, 0.1);
  EXPECT_THAT(svg.text(), AllOf(HasSubstr("one\n"), HasSubstr("two\n")));
}

TEST(Svg, LabelsTicksByPlainNumbersWithATrueMinus) {
  EXPECT_THAT(text_of(line_chart({{-0.3, -2e6}, {0.3, 2e6}})),
              AllOf(HasSubstr("−0.2\n"), HasSubstr("\n0\n"), HasSubstr("\n0.2\n"),
                    HasSubstr("−2000000\n"), HasSubstr("\n2000000\n"), Not(HasSubstr("-"))));
}

TEST(Svg, KeepsSpecialCharactersInEveryLabel) {
  const std::string odd = R"(<b> & "q" 'p' a_b^{c} @d \n 50 % `date` $x #1 ω²)";
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = odd + " title";
  chart.x.label = odd + " x";
  chart.series[0].mark = Mark::points;
  chart.x.categories = {"50 % <&> 'row' 0", "{a_b} `date` row 1"};
  chart.series[0].label = odd + " series";
  chart.lines = {{Direction::vertical, 1, odd + " line"}};
  chart.width = 1200;
  const ReadSvg svg(to_svg(chart));
  for (const std::string& name : chart.x.categories)
    EXPECT_THAT(svg.text(), HasSubstr(name + "\n"));
  std::string on_one_line = svg.text();  // a long name has several lines
  std::ranges::replace(on_one_line, '\n', ' ');
  for (const char* place : {" title", " x", " series", " line"})
    EXPECT_THAT(on_one_line, HasSubstr(odd + place + " "));
  EXPECT_EQ(svg.root().child_value("title"), odd + " title");
}

TEST(Svg, ReplacesWhatXmlCannotHold) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = std::string(
                    "a\x01\x1b"
                    "b\tc \xff d ") +
                '\0' + "e";
  EXPECT_THAT(text_of(chart), HasSubstr("a  b c \xEF\xBF\xBD d  e\n"));
}

TEST(Svg, IsNotFooledByLabelsThatLookLikeSvg) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = "</svg><g id='x'> url(#x)";
  EXPECT_THAT(text_of(chart), HasSubstr(chart.title));
}

TEST(Svg, LeavesAGapWhereAValueIsMissing) {
  const auto lines = [](const Chart& chart) {
    return ReadSvg(to_svg(chart)).lines_of("stroke", first_colour);
  };
  EXPECT_EQ(lines(line_chart({{0, 1}, {1, 2}, {2, 3}, {3, 1}, {4, 2}})), 1U);
  EXPECT_EQ(lines(line_chart({{0, 1}, {1, 2}, {2, {}}, {3, 1}, {4, 2}})), 2U);
}

TEST(Svg, ShowsALineOfOneSampleAsADot) {
  const ReadSvg svg(to_svg(line_chart({{3, 4}})));
  const auto paths = svg.paths("stroke", first_colour);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_STREQ(paths[0].node.attribute("stroke-linecap").value(), "round");
}

TEST(Svg, HatchesCellsWithoutAValueAndSaysSo) {
  const ReadSvg svg(to_svg(heat_map_chart({{1, {}, 3}, {{}, 5, 6}})));
  EXPECT_EQ(svg.lines_of("fill", "url(#map-hatching)"), 2U + 1U);  // and one in the legend
  EXPECT_THAT(svg.text(), HasSubstr("no value\n"));
  const ReadSvg complete(to_svg(heat_map_chart({{1, 2}})));
  EXPECT_EQ(complete.lines_of("fill", "url(#map-hatching)"), 0U);
  EXPECT_THAT(complete.text(), Not(HasSubstr("no value")));
}

TEST(Svg, CoversThePlotWithCellsAndWritesTheirValues) {
  const Chart chart = heat_map_chart({{0, 50}, {100, 25}});
  const Box plot = frame_of(chart).plot;
  const ReadSvg svg(to_svg(chart));
  EXPECT_THAT(svg.text(), AllOf(HasSubstr("\n50\n"), HasSubstr("\n100\n"), HasSubstr("\n25\n")));
  double area = 0;
  for (const ReadPath& path : svg.paths("shape-rendering", "crispEdges")) {
    for (const auto& cell : path.lines) {
      const auto [left, right] = std::ranges::minmax(cell, {}, &Pixel::x);
      const auto [top, bottom] = std::ranges::minmax(cell, {}, &Pixel::y);
      area += (right.x - left.x) * (bottom.y - top.y);
    }
  }
  EXPECT_NEAR(area, plot.width() * plot.height(), 0.01 * area);
  // Row 0 is the lowest, and the darkest colour is that of the lowest value.
  const auto darkest = svg.paths("fill", "#2b1c5e");
  ASSERT_EQ(darkest.size(), 1U);
  EXPECT_NEAR(darkest[0].lines[0][0].x, plot.left, 1);
  EXPECT_NEAR(darkest[0].lines[0][0].y, plot.bottom, 1);
}

TEST(Svg, SaysWhereThereIsNoDataAtAll) {
  EXPECT_THAT(text_of(line_chart({{0, {}}})), HasSubstr("no data"));
  EXPECT_THAT(text_of(line_chart({})), HasSubstr("no data"));
  EXPECT_THAT(text_of(heat_map_chart({{{}, {}}})), HasSubstr("no data"));
  EXPECT_THAT(text_of(line_chart({{0, 1}})), Not(HasSubstr("no data")));
}

TEST(Svg, NamesPointsWhereThereIsRoomAndPaleOnesOnlyNearby) {
  Chart chart = line_chart({});
  chart.series[0].mark = Mark::points;
  chart.series[0].samples = {{0, 1, Range{0.5, 2}, "first"}, {4, 3, {}, "second"}};
  Series crowd{"", Mark::points, {}, true};
  for (int k = 0; k < 40; ++k) crowd.samples.push_back({2, 2, {}, "crowd"});
  chart.series.push_back(crowd);
  const std::string text = text_of(chart);
  EXPECT_THAT(text, AllOf(HasSubstr("first"), HasSubstr("second"), HasSubstr("crowd")));
  std::size_t written = 0;
  for (auto at = text.find("crowd"); at != std::string::npos; at = text.find("crowd", at + 1)) {
    ++written;
  }
  EXPECT_LT(written, 9U);
}

TEST(Svg, WritesWhatCurvesAreCalledAtTheirEnds) {
  Chart chart = line_chart({{0, 5}, {10, 1}});
  chart.x.range = chart.y.range = Range{0, 10};
  chart.series.push_back({"high", Mark::steps, {{0, 5}, {10, 9}}});
  const Frame frame = frame_of(chart);
  EXPECT_TRUE(frame.legend.empty());
  EXPECT_EQ(frame.ends.size(), 2U);
  EXPECT_THAT(text_of(chart), AllOf(HasSubstr("path\n"), HasSubstr("high\n")));
}

TEST(Svg, KeepsAStepCurveOfManyEqualSamplesSmall) {
  Chart chart = line_chart({});
  chart.series[0].mark = Mark::steps;
  for (int i = 0; i < 1800; ++i) chart.series[0].samples.push_back({0.01 * i, i / 600});
  EXPECT_LT(to_svg(chart).size(), 6000U);
}

TEST(Svg, PaintsAreasBelowLinesAndNamesThem) {
  const std::vector<Chart> charts = gallery();
  const Chart& chart = charts.at(4);
  const std::string svg = to_svg(chart);
  EXPECT_THAT(text_of(chart), AllOf(HasSubstr("few"), HasSubstr("two"), HasSubstr("irregular")));
  const std::size_t area = svg.find(palette_colour(0.5)), line = svg.find("#1a1a1a");
  ASSERT_NE(area, std::string::npos);
  ASSERT_NE(line, std::string::npos);
  EXPECT_LT(area, line);
  EXPECT_THAT(svg, HasSubstr("-hatching)"));
  Chart narrow = chart;
  narrow.areas[0].name =
      "a name that is far too long for an area of this size and that of the whole plot";
  EXPECT_THAT(text_of(narrow), Not(HasSubstr("far too long")));
}

}  // namespace
}  // namespace ricochet::report
