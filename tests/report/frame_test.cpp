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

TEST(Frame, TurnsAndShortensNamesThatAreLongerThanTheirPlaces) {
  Chart chart = heat_map_chart({{1, 2, 3}});
  EXPECT_FALSE(frame_of(chart).names_turned);
  for (std::string& name : chart.x.categories) name = std::string(100, 'w');
  const Frame frame = frame_of(chart);
  EXPECT_TRUE(frame.names_turned);
  for (const Tick& tick : frame.x_ticks) EXPECT_THAT(tick.label, testing::EndsWith("w…"));
  EXPECT_LT(frame.plot.height(), frame_of(heat_map_chart({{1, 2, 3}})).plot.height());
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
    const double end = entry.place.x + key_width + 6 + text_width(entry.label);
    EXPECT_LE(end, frame.width);
    EXPECT_LE(entry.place.y, frame.height);
    for (std::size_t k = 0; k < i; ++k) {
      const Pixel& other = frame.legend[k].place;
      const double other_end = other.x + key_width + 6 + text_width(frame.legend[k].label);
      EXPECT_TRUE(std::abs(entry.place.y - other.y) >= 14 || entry.place.x > other_end);
    }
  }
}

TEST(Frame, HasRoomForEveryEntryOfTheLegend) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  EXPECT_TRUE(frame_of(chart).legend.empty());  // of one series
  for (std::size_t entries = 2; entries < 40; ++entries) {
    chart.series.push_back({"a series with a long name", Mark::points, {{0, 1}}});
    const Frame frame = frame_of(chart);
    EXPECT_EQ(frame.legend.size(), entries);
    expect_readable(frame);
  }
}

TEST(Frame, BreaksALongTitle) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = "A title that goes on and on until it is by far wider than a picture of this width";
  EXPECT_EQ(frame_of(chart).title.size(), 2U);
}

}  // namespace
}  // namespace ricochet::report
