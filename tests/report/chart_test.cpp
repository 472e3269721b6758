#include "src/report/chart.h"

#include <regex>

#include "src/report/drawing.h"
#include "src/report/svg.h"
#include "tests/report/pictures.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"

namespace ricochet::report {
namespace {

Chart logarithmic(Chart chart) {
  chart.x.scale = chart.y.scale = Scale::logarithmic;
  return chart;
}

/// With two areas.
Chart area_chart() {
  Chart chart = line_chart({{0, 1}, {4, 5}});
  chart.areas = {{"few", 0.5, {{{0, {0, 1}}, {4, {0, 5}}}}, "2"},
                 {"irregular", std::nullopt, {{{0, {1, 6}}, {4, {5, 6}}}}}};
  return chart;
}

TEST(Chart, RefusesWhatCannotBeDrawnAndSaysWhere) {
  const Chart line = line_chart({{0, 1}, {1, 2}}), map = heat_map_chart({{1, 2}, {3, 4}});
  const Range empty{1, 1}, falling{2, 1};
  const auto sample = [](const Sample& one) { return line_chart({one}); };
  const auto of_size = [&](int width, int height) {
    return changed(line, [&](Chart& chart) { chart.width = width, chart.height = height; });
  };
  const auto at = [](double place) {
    return [place](Chart& chart) { chart.lines = {{Direction::vertical, place, "wall"}}; };
  };
  const auto area = [](auto change) {
    return changed(area_chart(), [&](Chart& chart) { change(chart.areas[0]); });
  };
  const char* const sizes = "pixels must be between 1 and 10000";
  std::vector<Refusal<Chart>> refusals = {
      {logarithmic(line_chart({{1, 2.0}, {2, 0.0}})),
       "series \"path\", sample 1: 0 must be > 0 on the logarithmic axis \"x [mm]\""},
      {logarithmic(sample({1, 2.0, Range{-1, 3}})), "-1 must be > 0"},
      {logarithmic(sample({1e-301, 1})), "below 1e-300"},
      {sample({0, quiet_nan}), "nan is not finite"},
      {sample({infinity, 1}), "inf is not finite"},
      {sample({0, -1e101}), "beyond 1e100"},
      {sample({0, 1, falling}), "sample 0: 2 > 1 is not a range"},
      {sample({.position = 0, .value = 1, .name = "dot"}), "only points have names"},
      {of_size(480, 0), "480 x 0 pixels"},
      {of_size(0, 1), sizes},
      {of_size(10001, 1), sizes},
      {of_size(1, 10001), sizes},
      {line_chart({{1, 1}, {0, 1}}), "sample 1: positions must rise"},
      {changed(line, [&](Chart& chart) { chart.x.range = empty; }),
       "axis \"time [s]\": the range is empty"},
      {changed(line, at(infinity)), "reference line \"wall\": inf"},
      {logarithmic(changed(line_chart({{1, 1}}), at(0))), "reference line \"wall\": 0 must be > 0"},
      {heat_map_chart({{1, 2}, {3}}), "1 cells for 2 categories of x"},
      {heat_map_chart({{infinity}}), "cell: inf"},
      {changed(map, [](Chart& chart) { chart.y.categories.pop_back(); }),
       "2 rows for 1 categories of y"},
      {changed(map, [&](Chart& chart) { chart.heat_map->range = falling; }), "colours: 2 > 1"},
      {changed(map, [&](Chart& chart) { chart.series = line.series; }), "series and a heat map"},
      {changed(map, [](Chart& chart) { chart.areas = area_chart().areas; }),
       "areas and a heat map"},
      {area([](Area& one) { one.parts[0][0].position = 9; }), "edge 1: positions must rise"},
      {area([&](Area& one) { one.parts[0][0].between = falling; }), "edge 0: 2 > 1 is not"},
      {area([](Area& one) { one.parts.emplace_back(); }), "\"few\": a part has no edge"},
      {area([](Area& one) { one.shade = 1.5; }), "the shade must be within"},
      {area([](Area& one) { one.shade = -0.5; }), "the shade must be within"}};
  for (const char* name : {"", "a/b", "A", "a b", "a{", "a`"}) {
    refusals.push_back({changed(line, [&](Chart& chart) { chart.name = name; }), "the name must"});
  }
  expect_refusals<std::invalid_argument>([](const Chart& chart) { check(chart); }, refusals);
}

TEST(Chart, TakesGapsBehindWhichALineMayBeginAnew) {
  for (const Chart& chart :
       {line_chart({{0, 1}, {1, {}}, {2, 3}}),
        line_chart({{1, 1}, {2, 2}, {2, {}}, {0, 3}, {1, 4}}), area_chart(),
        heat_map_chart({{1, {}}}),
        changed(line_chart({{0, 1}}), [](Chart& one) { one.name = "a-z09", one.width = 10000; })}) {
    EXPECT_NO_THROW(check(chart)) << description(chart);
  }
}

TEST(Chart, DescribesAHeatMapByTheAxesThatHaveAName) {
  Chart map = heat_map_chart({{1}});
  map.y.label = "";
  EXPECT_EQ(description(map), "Heat map of threshold [rad/s] over restitution.");
  map.x.label = "";
  EXPECT_EQ(description(map), "Heat map of threshold [rad/s].");
  map.description = "Words.";
  EXPECT_EQ(description(map), "Words.");
}

Chart linked_map() {
  return {.name = "map",
          .title = "Map",
          .x = {.categories = {"hs", "top"}},
          .y = {.categories = {"solver b", "solver a"}},
          .heat_map = HeatMap{.label = "share [%]",
                              .rows = {{100, 0}, {50, std::nullopt}},
                              .row_links = {"view#entry=b", "view#entry=a"},
                              .column_links = {"&family=hs", "&family=top"}}};
}

TEST(CellLinks, AreThoseOfRowAndColumnAndLieOverTheCells) {
  const Json data = cell_links_data(linked_map());
  EXPECT_EQ(data["rows"].dump(),
            R"x([["solver a","view/index.html#entry=a"],["solver b","view/index.html#entry=b"]])x")
      << "from the top";
  EXPECT_EQ(data["columns"].dump(), R"x([["hs","&family=hs"],["top","&family=top"]])x");
  // The upper right cell has no value: its hatched rectangle ends where the box does.
  const std::string svg = to_svg(linked_map());
  std::smatch found;
  const std::regex gap(R"x(hatching\)"[^>]* d="M([0-9.]+) ([0-9.]+)h([0-9.]+)v-([0-9.]+))x");
  ASSERT_TRUE(std::regex_search(svg, found, gap)) << svg;
  const double left = std::stod(found[1]), bottom = std::stod(found[2]);
  const double width = std::stod(found[3]), height = std::stod(found[4]);
  const double whole_pixels = 1;  // of the edges of cells
  EXPECT_THAT(data["box"].get<std::vector<double>>(),
              ElementsAre(testing::DoubleNear(left - width, whole_pixels), left + width,
                          bottom - height, testing::DoubleNear(bottom + height, whole_pixels)));
}

TEST(CellLinks, MustFitTheChart) {
  for (const std::vector<std::string>& rows :
       {std::vector<std::string>{"view", "view"}, {"view#a"}, {"view#a", "view#b", "view#c"}}) {
    const Chart chart = changed(linked_map(), [&](Chart& map) { map.heat_map->row_links = rows; });
    EXPECT_THROW(cell_links_data(chart), std::invalid_argument) << rows.size();
  }
}

/// Position and value of each corner of each part.
using Corners = std::vector<std::vector<std::pair<double, double>>>;
Corners corners_of(Mark mark, const std::vector<Sample>& samples) {
  Corners parts;
  for (const auto& part : polylines({"", mark, samples})) {
    parts.emplace_back();
    for (const Sample& corner : part) parts.back().emplace_back(corner.position, *corner.value);
  }
  return parts;
}

TEST(Polyline, LeavesGapsWhereValuesAreMissing) {
  EXPECT_EQ(corners_of(Mark::line, {{0, 1}, {1, 1}, {2, {}}, {3, 1}}),
            (Corners{{{0, 1}, {1, 1}}, {{3, 1}}}));
}

TEST(Polyline, GivesStepsTheirCornersAndHoldsThemUntilTheirSuccessorEvenIfThatIsUnknown) {
  EXPECT_EQ(corners_of(Mark::steps, {{0, 5}, {3, 7}, {5, 7}}),
            (Corners{{{0, 5}, {3, 5}, {3, 7}, {5, 7}, {5, 7}}}));
  EXPECT_EQ(corners_of(Mark::steps, {{0, 5}, {1, {}}, {2, {}}}), (Corners{{{0, 5}, {1, 5}}}));
}

}  // namespace
}  // namespace ricochet::report
