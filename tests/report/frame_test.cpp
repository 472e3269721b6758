#include "src/report/frame.h"

#include <gmock/gmock.h>

#include "src/report/text.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

TEST(Frame, GrowsWhereTheDataHaveNoRoom) {
  Chart chart = heat_map_chart({{1}});
  chart.width = chart.height = 1;
  const Frame frame = frame_of(chart);
  EXPECT_GE(frame.plot.width(), 60);
  EXPECT_GE(frame.plot.height(), 30);
  EXPECT_GT(frame.width, frame.plot.right);
  EXPECT_GT(frame.height, frame.plot.bottom);
}

TEST(Frame, IsOtherwiseOfTheChartsSize) {
  for (const Chart& chart : {line_chart({{0, 1}, {1, 2}}), heat_map_chart({{1, 2}, {3, 4}})}) {
    EXPECT_EQ(frame_of(chart).width, chart.width);
    EXPECT_EQ(frame_of(chart).height, chart.height);
  }
}

TEST(Frame, TurnsNamesThatAreLongerThanTheirPlacesAndShortensOnlyVeryLongOnes) {
  Chart chart = heat_map_chart({{1, 2, 3}});
  EXPECT_FALSE(frame_of(chart).names_turned);
  for (std::string& name : chart.x.categories) name = std::string(40, 'w');
  const Frame frame = frame_of(chart);
  EXPECT_TRUE(frame.names_turned);
  for (const Tick& tick : frame.x_ticks) EXPECT_EQ(tick.label, chart.x.categories[0]);
  EXPECT_LT(frame.plot.height(), frame_of(heat_map_chart({{1, 2, 3}})).plot.height());
  EXPECT_GT(frame.height, chart.height);
  for (std::string& name : chart.x.categories) name = std::string(400, 'w');
  for (const Tick& tick : frame_of(chart).x_ticks) EXPECT_THAT(tick.label, testing::EndsWith("w…"));
}

TEST(Frame, BreaksLongLabelsIntoLinesAndGrowsWithAWordThatIsTooLong) {
  Chart chart = heat_map_chart({{1, 2}, {3, 4}});
  const double plot = frame_of(chart).plot.width();
  chart.y.label = chart.heat_map->label =
      "optimality gap [tolerances of the problem] that is allowed";
  Frame frame = frame_of(chart);
  ASSERT_EQ(frame.labels.size(), 3U);
  EXPECT_EQ(frame.labels[1].lines.size(), 2U);
  EXPECT_EQ(frame.labels[2].lines.size(), 2U);
  EXPECT_EQ(frame.plot.width(), plot - 2 * line_height) << "a line more on both sides";
  EXPECT_EQ(frame.height, chart.height);
  chart.y.label = std::string(60, 'w');
  frame = frame_of(chart);
  EXPECT_EQ(frame.labels[1].lines, std::vector{chart.y.label});
  EXPECT_GT(frame.height, text_width(chart.y.label));
}

TEST(Frame, RepeatsTheNamesOfColumnsAboveALongHeatMap) {
  using Rows = std::vector<std::vector<std::optional<double>>>;
  Chart chart = heat_map_chart(Rows(20, {1, 2}));
  EXPECT_FALSE(frame_of(chart).names_above);
  const double cells = frame_of(chart).plot.height();
  chart = heat_map_chart(Rows(21, {1, 2}));
  const Frame frame = frame_of(chart);
  EXPECT_TRUE(frame.names_above);
  EXPECT_EQ(frame.plot.height(), cells) << "the picture grows, not the names' room alone";
  EXPECT_GT(frame.plot.top, frame_of(heat_map_chart(Rows(20, {1, 2}))).plot.top);
}

TEST(Frame, LeavesNamesOutWhereTheyWouldLieOnEachOther) {
  Chart chart = heat_map_chart({std::vector<std::optional<double>>(200, 1.0)});
  const Frame frame = frame_of(chart);
  ASSERT_GT(frame.x_ticks.size(), 2U);
  EXPECT_LT(frame.x_ticks.size(), 30U);
  EXPECT_GT((frame.x_ticks[1].position - frame.x_ticks[0].position) * frame.plot.width() / 200,
            text_width("c100"));
}

/// A legend whose entries neither leave the picture nor lie on each other.
void expect_readable(const Frame& frame) {
  for (std::size_t i = 0; i < frame.legend.size(); ++i) {
    const LegendEntry& entry = frame.legend[i];
    const double end = entry.place.x + key_width + 6 + widest(entry.lines);
    EXPECT_LE(end, frame.width);
    EXPECT_LE(entry.place.y + line_height * (static_cast<double>(entry.lines.size()) - 1),
              frame.height);
    for (std::size_t k = 0; k < i; ++k) {
      const LegendEntry& other = frame.legend[k];
      const double other_end = other.place.x + key_width + 6 + widest(other.lines);
      const double lines = static_cast<double>(other.lines.size());
      EXPECT_TRUE(entry.place.y - other.place.y >= line_height * lines - 1 ||
                  entry.place.x > other_end);
    }
  }
}

TEST(Frame, HasRoomForEveryEntryOfTheLegend) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  EXPECT_TRUE(frame_of(chart).legend.empty());  // of one series
  for (std::size_t entries = 2; entries < 40; ++entries) {
    const auto value = static_cast<double>(entries);
    chart.series.push_back(
        {entries % 3 == 0 ? "a long name" : "a series with a name that has two lines",
         Mark::points,
         {{value, value}}});
    const Frame frame = frame_of(chart);
    EXPECT_EQ(frame.legend.size(), entries);
    expect_readable(frame);
  }
}

std::vector<std::string> legend_of(const Chart& chart) {
  std::vector<std::string> labels;
  for (const LegendEntry& entry : frame_of(chart).legend) labels.push_back(entry.lines.front());
  return labels;
}

TEST(Frame, HasEntriesInTheLegendForWhatIsSeen) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.x.range = Range{0, 1};
  chart.y.range = Range{0, 4};
  chart.series.push_back({"points", Mark::points, {{0.5, 3}}});
  chart.series.push_back({"above", Mark::line, {{0, 5}, {1, 6}}});
  chart.series.push_back({"crosses", Mark::line, {{0, -90}, {1, 90}}});
  chart.series.push_back({"no value", Mark::line, {{0, {}}, {1, {}}}});
  chart.areas = {{"low", 0.5, {{{0, {0, 1}}, {1, {0, 1}}}}},
                 {"high", 0.9, {{{0, {5, 6}}, {1, {5, 6}}}}}};
  chart.lines = {{Direction::horizontal, 2, "inside"}, {Direction::vertical, 2, "outside"}};
  EXPECT_THAT(legend_of(chart), testing::ElementsAre("low", "path", "points", "crosses", "inside"));
}

TEST(Frame, HasOneEntryForSeriesThatCannotBeToldApart) {
  Chart chart = line_chart({{0, 1}, {1, 2}, {2, 1}});
  chart.y.range = Range{0, 4};
  chart.series.push_back(
      {"dashed", Mark::line, {{0, 1.003}, {1, 2.003}, {2, 1.003}}});  // 0.2 pixels
  chart.series.push_back({"elsewhere", Mark::line, {{0, 1}, {1, 2}, {2, 1.5}}});
  // Solid, and hides what lies below; the next is dashed, and shows it.
  chart.series.push_back({"longer", Mark::line, {{-1, 1}, {0, 1}, {1, 2}, {2, 1}}});
  chart.series.push_back({"longest", Mark::line, {{-2, 1}, {0, 1}, {1, 2}, {2, 1}}});
  chart.x.range = Range{-2, 3};
  EXPECT_THAT(legend_of(chart),
              testing::ElementsAre("path; dashed; longer", "elsewhere", "longest"));
  EXPECT_THAT(frame_of(chart).legend[0].numbers, testing::ElementsAre(0, 1, 3));
}

TEST(Frame, NamesTheReferenceLineBesideEndLabels) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.series.push_back({"other", Mark::line, {{0, 1}, {1, 9}}});
  chart.x.range = Range{0, 1};
  chart.lines = {{Direction::horizontal, 2, "limit"}};
  EXPECT_EQ(frame_of(chart).ends.size(), 2U);
  EXPECT_THAT(legend_of(chart), testing::ElementsAre("limit"));
}

TEST(Frame, HasColoursWithZeroInTheMiddle) {
  const Frame frame = frame_of(heat_map_chart({{-8, 11}}));
  EXPECT_EQ(frame.colours.lower, -11);
  EXPECT_EQ(frame.colours.upper, 11);
  EXPECT_EQ(frame_of(heat_map_chart({{0, 11}})).colours.lower, 0);
}

TEST(Frame, BreaksALongTitle) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = "A title that goes on and on until it is by far wider than a picture of this width";
  EXPECT_EQ(frame_of(chart).title.size(), 2U);
}

}  // namespace
}  // namespace ricochet::report
