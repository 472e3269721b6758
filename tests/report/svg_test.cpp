#include "src/report/svg.h"

#include <regex>

#include "src/report/drawing.h"
#include "src/report/frame.h"
#include "src/report/painted.h"
#include "tests/report/pictures.h"
#include "tests/support/files.h"
#include "tests/support/golden.h"
#include "tests/support/numbers.h"

namespace ricochet::report {
namespace {

std::string texts_of(const Chart& chart) {
  return ReadSvg(to_svg(chart)).text();
}

Chart named(const char* name, const Chart& chart, void (*change)(Chart&)) {
  return changed(chart, [&](Chart& one) { one.name = name, change(one); });
}

/// One of every kind.
std::vector<Chart> gallery() {
  const Chart line = line_chart({{0, 1}, {1, 2}});
  return {
      line,
      // A line and its band end at the edge of the plot.
      named("clipped", line_chart({{0, 0, Range{-1, 1}}, {10, 100, Range{90, 110}}}),
            [](Chart& chart) {
              chart.y.range = Range{0, 50};
            }),
      // With a band, a gap, and one sample alone: a dot.
      named("steps",
            line_chart({{1, 1.0 / 3, Range{0.5, 2}}, {10, 5, Range{4, 6}}, {100, {}}, {1000, 7}}),
            [](Chart& chart) {
              chart.series[0].label = "a \"b\", c";
              chart.series[0].mark = Mark::steps;
              chart.x.scale = Scale::logarithmic;
              chart.lines = {{Direction::vertical, 9, "paper"},
                             {Direction::horizontal, 3, "wall"},
                             {Direction::horizontal, 4, "wall"}};
            }),
      named("names", line_chart({{0, 3, Range{2, 3.5}}, {1, {}}}),
            [](Chart& chart) {
              chart.series[0].mark = Mark::points;
              chart.x.categories = {"first", "second"};
            }),
      named("many", line,
            [](Chart& chart) {
              for (int i = 0; i < 11; ++i)
                chart.series.push_back(
                    {"solver " + std::to_string(i), Mark::points, {{0.5, 1.0 + i}}});
            }),
      // What curves are called stands at their ends.
      named("ends", line_chart({{0, -5}, {10, -9}}),
            [](Chart& chart) {
              chart.x.range = Range{0, 10};
              chart.y.range = Range{-10, 0};
              chart.series.push_back({"high", Mark::steps, {{0, -5}, {10, -1}}});
              chart.series.push_back({"higher", Mark::line, {{0, -5}, {10, -0.8}}});
            }),
      named("dots", line_chart({{0, 1, {}, "one"}, {1, 2, {}, "two"}}),
            [](Chart& chart) {
              chart.series[0].mark = Mark::points;
              chart.series.push_back({"pale", Mark::points, {{0.02, 1, {}, "near"}}, true});
            }),
      // Below the line, which is dark; one of the areas has a name that has no room.
      named("areas", line_chart({{0, 1}, {4, 5}}),
            [](Chart& chart) {
              chart.series[0].dark = true;
              chart.areas = {{"few", 0.5, {{{0, {0, 1}}, {4, {0, 5}}}}, "two"},
                             {"no room", 0.8, {{{4, {0, 1}}, {4.1, {0, 5}}}}, "wide"},
                             {"irregular", std::nullopt, {{{0, {1, 6}}, {4, {5, 6}}}}, {}}};
            }),
      heat_map_chart({{1.5, 2}, {{}, 4}}),
      // Zero has no sign, and colours diverge.
      named("differences", heat_map_chart({{-50, -0.0004, 25}, {0.1 + 0.2, 1e-7, {}}}),
            [](Chart& chart) {
              chart.y.categories[1] = "=above";
              chart.x.label = "";
            }),
      named("large", heat_map_chart(Cells(21, {1, 2})), [](Chart&) {})};
}

TEST(Svg, AndTheNumbersOfEveryKindOfChartAreAsTheyWere) {
  std::vector<std::string> pictures;
  std::string numbers;
  for (const Chart& chart : gallery()) {
    pictures.push_back(to_svg(chart));
    if (chart.name != "many" && chart.name != "large") numbers += csv_of(chart) + "\n";
  }
  expect_golden(stacked(pictures), "charts.svg");
  EXPECT_EQ(stacked({pictures[0]}), pictures[0]);
  expect_golden(numbers, "charts.csv");
}

TEST(Svg, IsWellFormedAndPointsToItsOwnIdsWhichNoOtherChartHas) {
  static const std::regex pattern("url\\(#([^\")]*)");
  std::set<std::string> all;
  int references = 0;
  for (const Chart& chart : gallery()) {
    const std::string svg = to_svg(chart);
    EXPECT_THAT(svg, AllOf(StartsWith("<svg class=\"ricochet-chart\""), HasSubstr("role=\"img\""),
                           Not(HasSubstr("<script"))));
    const ReadSvg picture(svg);
    std::set<std::string> own;
    for (const auto& id : picture.root().select_nodes("//@id"))
      EXPECT_TRUE(all.insert(*own.insert(id.attribute().value()).first).second) << svg;
    EXPECT_GE(own.size(), 2U);
    for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it) {
      EXPECT_THAT(own, Contains((*it)[1].str()));
      ++references;
    }
  }
  EXPECT_GT(references, 5);
}

TEST(Svg, PutsValuesWhereTheAxesSayAndDecadesAtEqualDistances) {
  Chart chart = line_chart({{1, 0}, {10, 100}, {100, 50}});
  chart.x.scale = Scale::logarithmic;
  chart.x.range = Range{1, 100};
  chart.y.range = Range{0, 100};
  const Box plot = frame_of(chart).plot;
  const auto paths = ReadSvg(to_svg(chart)).paths("stroke", "#0072b2");
  ASSERT_EQ(paths.size(), 1U);
  const auto is_at = [](double x, double y) {
    return FieldsAre(testing::DoubleNear(x, 0.1), testing::DoubleNear(y, 0.1));
  };
  EXPECT_THAT(paths[0].lines.at(0), ElementsAre(is_at(plot.left, plot.bottom),
                                                is_at((plot.left + plot.right) / 2, plot.top),
                                                is_at(plot.right, (plot.top + plot.bottom) / 2)));
}

TEST(Svg, KeepsSpecialCharactersInEveryLabel) {
  const std::string odd =
      R"(</svg><b id='x'> url(#x) & "q" 'p' a_b^{c} @d \n 50 % `date` $x #1 ω²)";
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = odd + " title";
  chart.x.label = odd + " x";
  chart.series[0].mark = Mark::points;
  chart.x.categories = {"50 % <&> 'row' 0", "{a_b} `date` row 1"};
  chart.series[0].label = odd + " series";
  chart.lines = {{Direction::vertical, 1, odd + " line"}};
  chart.width = 1400;
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
  using namespace std::string_literals;
  chart.title = "a\001\033b\tc \xff d \0e"s;
  EXPECT_THAT(texts_of(chart), HasSubstr("a  b c \xEF\xBF\xBD d  e\n"));
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
  for (const Chart& chart : {line_chart({{0, {}}}), line_chart({}), heat_map_chart({{{}, {}}})}) {
    EXPECT_THAT(texts_of(chart), HasSubstr("no data"));
  }
  EXPECT_THAT(texts_of(line_chart({{0, 1}})), Not(HasSubstr("no data")));
}

TEST(Svg, NamesPointsWhereThereIsRoomAndPaleOnesOnlyNearby) {
  Chart chart = line_chart({{0, 1, Range{0.5, 2}, "first"}, {4, 3, {}, "second"}});
  chart.series[0].mark = Mark::points;
  chart.series.push_back({"", Mark::points, std::vector<Sample>(40, {2, 2, {}, "crowd"}), true});
  const std::vector<std::string> names = lines_of(texts_of(chart));
  EXPECT_THAT(names, testing::IsSupersetOf({"first", "second", "crowd"}));
  EXPECT_LT(std::ranges::count(names, "crowd"), 9);
}

TEST(Svg, KeepsAStepCurveOfManyEqualSamplesSmall) {
  Chart chart = line_chart({});
  chart.series[0].mark = Mark::steps;
  for (int i = 0; i < 1800; ++i) chart.series[0].samples.push_back({0.01 * i, i / 600});
  EXPECT_LT(to_svg(chart).size(), 6000U);
}

TEST(ReferenceCharts, HaveTheirTextsWholeAndInThePicture) {
  int charts = 0;
  for (const fs::path& file :
       fs::recursive_directory_iterator(RICOCHET_SOURCE "/reports/reference")) {
    const bool by_hand = file.stem() == "machine-sketch" || file.stem() == "machine";  // in groups
    if (file.extension() != ".svg" || by_hand) continue;
    EXPECT_EQ(ReadSvg(text_of(file)).cut_texts(), "") << file;
    ++charts;
  }
  EXPECT_GT(charts, 100);
}

TEST(PathData, GoesFromCornerToCorner) {
  EXPECT_EQ(path_data({{{{60.2, 218.34}, {60.2, 54}}}, {{{70, 54}, {80, 54}, {79.5, 60}}}}),
            "M60.2 218.3v-164.3m9.8 0h10l-.5 6");
  EXPECT_EQ(path_data({{{{1, 1}, {3, 1}, {3, 2}}, true}, {{{1.5, 1}, {2, 1.5}}}}),
            "M1 1h2v1zm.5 0l.5.5");
  EXPECT_EQ(path_data({{{{3, 4}}}, {{{5, 4}}}}), "M3 4h0m2 0h0") << "dots";
  EXPECT_EQ(path_data({{{{3, 4}}, true, 2}, {{{4, 4}, {4, 5}}}}),
            "M3 4m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0zm3 0v1")
      << "arcs of a circle";
  EXPECT_EQ(path_data({}), "");
}

TEST(PathData, DrawsOnceWhatLiesOnEachOther) {
  EXPECT_EQ(path_data({{{{3, 4}}}, {{{3.04, 3.96}}}, {{{3.1, 4}}}}), "M3 4h0m.1 0h0");
  const Outline box{{{0, 0}, {4, 0}, {4, 4}}, true};
  EXPECT_EQ(path_data({box, box}), path_data({box}));
}

TEST(PathData, EndsWhereTheLineDoesHoweverManyStepsThereAre) {
  Outline spiral;
  for (int i = 0; i <= 2000; ++i) {
    const double turn = i / 100.0;
    spiral.corners.push_back({200 + 9 * turn * std::cos(turn), 200 + 9 * turn * std::sin(turn)});
  }
  const std::string data = path_data({spiral});
  EXPECT_LT(data.size(), 5000U);
  const Pixel end = lines_in(data).at(0).back();
  EXPECT_NEAR(end.x, spiral.corners.back().x, 0.051);
  EXPECT_NEAR(end.y, spiral.corners.back().y, 0.051);
}

/// The value of a line at a position within it.
double value_at(const std::vector<Sample>& line, double position) {
  const auto right = std::find_if(line.begin() + 1, line.end() - 1, [&](const Sample& sample) {
    return sample.position >= position;
  });
  const auto left = right - 1;
  const double share = (position - left->position) / (right->position - left->position);
  return *left->value + share * (*right->value - *left->value);
}

TEST(Simplified, LeavesOutWhatLiesOnAStraightLineAndKeepsWhatIsShort) {
  const auto corners = simplified({{0, 0}, {1, 1}, {2, 2}, {3, 1}, {4, 0}}, 1e-3, 1e-3);
  ASSERT_EQ(corners.size(), 3U);
  EXPECT_EQ(corners[1].position, 2);
  EXPECT_TRUE(simplified({}, 1, 1).empty());
  EXPECT_EQ(simplified({{0, 1}}, 1, 1).size(), 1U);
  EXPECT_EQ(simplified({{0, 1}, {1, 1}}, 100, 100).size(), 2U);
  EXPECT_THAT(needed_corners({{0, 0}, {5, 0}, {0, 0}}, 0.1), ElementsAre(0, 1, 2))
      << "the way there and back";
}

TEST(Simplified, IsNowhereOffByMoreThanItMay) {
  std::vector<Sample> wave;
  for (int i = 0; i <= 1000; ++i) wave.push_back({i / 1e3, std::abs(std::sin(i / 50.0))});
  const double off = 0.01;
  const auto corners = simplified(wave, 1e-9, off);  // so narrow that only the value counts
  EXPECT_LT(corners.size(), 120U);
  EXPECT_GT(corners.size(), 20U);
  for (const Sample& sample : wave) {
    EXPECT_LE(std::abs(value_at(corners, sample.position) - *sample.value), 1.001 * off);
  }
}

TEST(DrawnChart, IsThePictureOrElseTheReasonInWords) {
  const Chart chart = line_chart({{0, 1}, {1, 2}});
  const DrawnChart drawn = draw(chart);
  EXPECT_TRUE(drawn.is_drawn());
  EXPECT_THAT(html_of(chart, drawn), StartsWith(to_svg(chart)));
  EXPECT_EQ(markdown_of(drawn), "![A title](chart.svg)");

  const Chart wrong = changed(line_chart({{0, quiet_nan}}),
                              [](Chart& one) { one.name = "wrong", one.title = "Wrong <one>"; });
  const DrawnChart none = draw(wrong);
  EXPECT_FALSE(none.is_drawn());
  EXPECT_EQ(failure_of(none),
            "chart wrong could not be drawn: series \"path\", sample 0: nan is not finite");
  EXPECT_THAT(html_of(wrong, none),
              AllOf(HasSubstr("Wrong &lt;one&gt;"), HasSubstr("nan is not finite")));
  EXPECT_THAT(markdown_of(none), AllOf(HasSubstr("Wrong &lt;one>"), HasSubstr("not finite")));
  const Plot plot = plot_of({wrong, chart});
  EXPECT_EQ(plot.svg, to_svg(chart));
  EXPECT_THAT(plot.failures, ElementsAre(failure_of(none)));
  EXPECT_EQ(plot_of({wrong}).svg, "");
}

TEST(Failures, EndACommandIfThereAreAny) {
  EXPECT_NO_THROW(require_none({}));
  EXPECT_THAT(([] {
                require_none({"chart a", "chart b"});
              }),
              testing::ThrowsMessage<std::runtime_error>("chart a; chart b"));
}

}  // namespace
}  // namespace ricochet::report
