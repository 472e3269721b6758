#include "src/report/frame.h"

#include "src/report/text.h"
#include "tests/report/pictures.h"

namespace ricochet::report {
namespace {

std::vector<std::string> labels_of(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(Ticks, AreRound) {
  EXPECT_THAT(labels_of(linear_ticks({-0.42, 0.41}, 5, false)),
              ElementsAre("−0.4", "−0.2", "0", "0.2", "0.4"));
  EXPECT_THAT(labels_of(linear_ticks({0, 1000}, 2, false)), ElementsAre("0", "500", "1000"));
  EXPECT_THAT(labels_of(linear_ticks({0, 999}, 1, false)), ElementsAre("0"));
  EXPECT_THAT(labels_of(linear_ticks({-0.1, 2.1}, 8, true)), ElementsAre("0", "1", "2"))
      << "whole numbers have no fractions";
  EXPECT_LE(linear_ticks({1e9, std::nextafter(1e9, 2e9)}, 5, false).size(), 11U)
      << "few, however narrow the limits";
}

TEST(Ticks, OfALogarithmicAxisArePowersOfTenOrTwoAndFiveTooOrThoseOfALinearOne) {
  EXPECT_THAT(labels_of(logarithmic_ticks({1e-6, 1e-2}, 3)), ElementsAre("10⁻⁶", "10⁻⁴", "10⁻²"));
  EXPECT_THAT(labels_of(logarithmic_ticks({1, 20}, 5)), ElementsAre("1", "2", "5", "10", "20"));
  EXPECT_THAT(labels_of(logarithmic_ticks({21, 79}, 4)), ElementsAre("30", "50", "70"));
  EXPECT_THAT(labels_of(logarithmic_ticks({101, 109}, 4)), ElementsAre("102", "104", "106", "108"));
}

TEST(NumberLabel, IsWhatAReaderWrites) {
  EXPECT_EQ(number_label(-0.5), "−0.5");
  EXPECT_EQ(number_label(2e6), "2000000");
  EXPECT_EQ(number_label(3e-7), "3×10⁻⁷");
  EXPECT_EQ(number_label(-1e20), "−10²⁰");
}

TEST(Limits, HaveRoomAroundASingleValue) {
  EXPECT_LT(limits({3}, Scale::linear).lower, 3);
  EXPECT_GT(limits({3}, Scale::logarithmic).upper, 3);
  EXPECT_LT(limits({0}, Scale::linear).lower, 0);
}

TEST(Frame, GrowsWhereTheDataHaveNoRoomAndIsOtherwiseOfTheChartsSize) {
  const Frame frame = frame_of(
      changed(heat_map_chart({{1}}), [](Chart& chart) { chart.width = chart.height = 1; }));
  EXPECT_GE(frame.plot.width(), 60);
  EXPECT_GE(frame.plot.height(), 30);
  EXPECT_GT(frame.width, frame.plot.right);
  EXPECT_GT(frame.height, frame.plot.bottom);
  for (const Chart& chart : {line_chart({{0, 1}, {1, 2}}), heat_map_chart({{1, 2}, {3, 4}})}) {
    EXPECT_EQ(frame_of(chart).width, chart.width);
    EXPECT_EQ(frame_of(chart).height, chart.height);
  }
}

TEST(Frame, TurnsNamesThatAreLongerThanTheirPlacesAndShortensOnlyVeryLongOnes) {
  Chart chart = heat_map_chart({{1, 2, 3}});
  const Frame plain = frame_of(chart);
  EXPECT_FALSE(plain.names_turned);
  chart.x.categories.assign(3, std::string(40, 'w'));
  const Frame frame = frame_of(chart);
  EXPECT_TRUE(frame.names_turned);
  EXPECT_EQ(labels_of(frame.x_ticks), chart.x.categories);
  EXPECT_LT(frame.plot.height(), plain.plot.height());
  EXPECT_GT(frame.height, chart.height);
  chart.x.categories.assign(3, std::string(400, 'w'));
  EXPECT_THAT(labels_of(frame_of(chart).x_ticks), Each(EndsWith("w…")));
}

TEST(Frame, BreaksALongTitleAndLongLabelsIntoLinesAndGrowsWithAWordThatIsTooLong) {
  Chart chart = heat_map_chart({{1, 2}, {3, 4}});
  const double plot = frame_of(chart).plot.width();
  chart.y.label = chart.heat_map->label = "optimality gap [tolerances of the problem] allowed";
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
  chart.title = "A title that goes on and on until it is by far wider than a picture of this width";
  EXPECT_EQ(frame_of(chart).title.size(), 2U);
}

TEST(Frame, RepeatsTheNamesOfColumnsAboveALongHeatMap) {
  const Frame twenty = frame_of(heat_map_chart(Cells(20, {1, 2})));
  const Frame more = frame_of(heat_map_chart(Cells(21, {1, 2})));
  EXPECT_FALSE(twenty.names_above);
  EXPECT_TRUE(more.names_above);
  EXPECT_EQ(more.plot.height(), twenty.plot.height())
      << "the picture grows, not the names' room alone";
  EXPECT_GT(more.plot.top, twenty.plot.top);
}

TEST(Frame, LeavesNamesOutWhereTheyWouldLieOnEachOther) {
  const Frame frame = frame_of(heat_map_chart({std::vector<std::optional<double>>(200, 1.0)}));
  ASSERT_GT(frame.x_ticks.size(), 2U);
  EXPECT_LT(frame.x_ticks.size(), 30U);
  EXPECT_GT((frame.x_ticks[1].position - frame.x_ticks[0].position) * frame.plot.width() / 200,
            text_width("c100"));
}

/// Its entries neither leave the picture nor lie on each other.
TEST(Frame, HasRoomForEveryEntryOfTheLegend) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  EXPECT_THAT(frame_of(chart).legend, IsEmpty()) << "of one series";
  for (std::size_t entries = 2; entries < 40; ++entries) {
    const auto value = static_cast<double>(entries);
    chart.series.push_back(
        {entries % 3 == 0 ? "a long name" : "a series with a name that has two lines",
         Mark::points,
         {{value, value}}});
    const Frame frame = frame_of(chart);
    std::vector<Box> places;
    for (const LegendEntry& entry : frame.legend) {
      const auto [x, y] = entry.place;
      const Box place{x, x + key_width + 6 + widest(entry.lines), y,
                      y + line_height * static_cast<double>(entry.lines.size())};
      EXPECT_LE(place.right, frame.width);
      EXPECT_LE(place.bottom - line_height, frame.height);
      for (const Box& other : places)
        EXPECT_TRUE(place.top >= other.bottom - 1 || place.left > other.right);
      places.push_back(place);
    }
    EXPECT_EQ(places.size(), entries);
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
  chart.series.insert(chart.series.end(), {{"points", Mark::points, {{0.5, 3}}},
                                           {"above", Mark::line, {{0, 5}, {1, 6}}},
                                           {"crosses", Mark::line, {{0, -90}, {1, 90}}},
                                           {"no value", Mark::line, {{0, {}}, {1, {}}}}});
  chart.areas = {{"low", 0.5, {{{0, {0, 1}}, {1, {0, 1}}}}},
                 {"high", 0.9, {{{0, {5, 6}}, {1, {5, 6}}}}}};
  chart.lines = {{Direction::horizontal, 2, "inside"}, {Direction::vertical, 2, "outside"}};
  EXPECT_THAT(legend_of(chart), ElementsAre("low", "path", "points", "crosses", "inside"));
}

TEST(Frame, HasOneEntryForSeriesThatCannotBeToldApart) {
  Chart chart = line_chart({{0, 1}, {1, 2}, {2, 1}});
  chart.x.range = Range{-2, 3};
  chart.y.range = Range{0, 4};
  chart.series.insert(chart.series.end(),
                      {{"dashed", Mark::line, {{0, 1.003}, {1, 2.003}, {2, 1.003}}},  // 0.2 pixels
                       {"elsewhere", Mark::line, {{0, 1}, {1, 2}, {2, 1.5}}},
                       // Solid, and hides what lies below; the next is dashed, and shows it.
                       {"longer", Mark::line, {{-1, 1}, {0, 1}, {1, 2}, {2, 1}}},
                       {"longest", Mark::line, {{-2, 1}, {0, 1}, {1, 2}, {2, 1}}}});
  EXPECT_THAT(legend_of(chart), ElementsAre("path; dashed; longer", "elsewhere", "longest"));
  EXPECT_THAT(frame_of(chart).legend[0].numbers, ElementsAre(0, 1, 3));
}

constexpr double plot_height = 200;  // pixels

/// Two curves that end at these values.
Chart two_curves(double high, double low = 1) {
  Chart chart{.name = "two", .x = {.label = "x"}, .y = {.label = "y"}};
  chart.x.range = chart.y.range = Range{0, 10};
  chart.series = {{"low", Mark::line, {{0, 5}, {10, low}}},
                  {"high", Mark::steps, {{0, 5}, {10, high}}}};
  return chart;
}

std::vector<EndLabel> ends_of(const Chart& chart) {
  return end_labels(chart, *chart.x.range, *chart.y.range, plot_height);
}

TEST(EndLabels, StandWhereCurvesEndApartInsteadOfALegendThatNamesReferenceLinesAlone) {
  Chart chart = two_curves(9);
  const auto ends = ends_of(chart);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[1].text, "high");
  EXPECT_NEAR(ends[1].place, 0.9, 1e-12);
  EXPECT_EQ(frame_of(chart).ends.size(), 2U);
  EXPECT_THAT(legend_of(chart), IsEmpty());
  chart.lines = {{Direction::horizontal, 2, "limit"}};
  EXPECT_EQ(frame_of(chart).ends.size(), 2U);
  EXPECT_THAT(legend_of(chart), ElementsAre("limit"));
}

TEST(EndLabels, LeaveTheLegendWhereThereAreManyOrTheyWouldBeFar) {
  Chart many = two_curves(9), far = two_curves(1);
  for (int i = 2; i < 6; ++i) {
    many.series.push_back({"more", Mark::line, {{0, 5}, {10, 1.5 * i}}});
    far.series.push_back({"too", Mark::line, {{0, 5}, {10, 0}}});
  }
  EXPECT_EQ(ends_of(many).size(), 6U);
  many.series.push_back({"one too many", Mark::line, {{0, 5}, {10, 5}}});
  EXPECT_THAT(ends_of(many), IsEmpty());
  EXPECT_THAT(ends_of(far), IsEmpty()) << "the highest at the bottom is 70 pixels from its curve";
}

TEST(EndLabels, AreMovedApartAndLedTo) {
  const auto both = ends_of(two_curves(1.5));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NEAR(both[0].place, 0.125 - 7 / plot_height, 1e-12) << "both give way by the same";
  EXPECT_NEAR(both[1].place, 0.125 + 7 / plot_height, 1e-12);
  EXPECT_FALSE(need_leaders(both, plot_height)) << "by 2 pixels";
  Chart close = two_curves(1.1);
  close.series.push_back({"third", Mark::line, {{0, 5}, {10, 1.2}}});
  const auto led = ends_of(close);
  ASSERT_EQ(led.size(), 3U);
  EXPECT_NEAR(led[2].place - led[1].place, 14 / plot_height, 1e-12);
  EXPECT_TRUE(need_leaders(led, plot_height));
  const auto lowest = ends_of(two_curves(0.1, 0));
  ASSERT_EQ(lowest.size(), 2U);
  EXPECT_EQ(lowest[0].place, 0) << "where the plot ends they do, too";
  EXPECT_NEAR(lowest[1].place, 14 / plot_height, 1e-12);
}

TEST(EndLabels, AreOfAllCurvesOrOfNone) {
  using Curves = std::vector<Series>;
  const auto number = [](void (*change)(Curves&)) {
    return ends_of(changed(two_curves(9), [&](Chart& chart) { change(chart.series); })).size();
  };
  EXPECT_EQ(number([](Curves& all) { all[0].samples.back().position = 8; }), 0U);
  EXPECT_EQ(number([](Curves& all) { all[0].samples.back().value.reset(); }), 0U);
  EXPECT_EQ(number([](Curves& all) { all[1].samples.back().value = 11; }), 0U);
  EXPECT_EQ(number([](Curves& all) { all[1].mark = Mark::points; }), 0U);
  EXPECT_EQ(number([](Curves& all) { all[0].label = std::string(80, 'w'); }), 0U);
  EXPECT_EQ(number([](Curves& all) { all.pop_back(); }), 0U);
  Chart unnamed = two_curves(9);
  unnamed.series.push_back({"", Mark::line, {{0, 0}, {5, 5}}});
  EXPECT_EQ(ends_of(unnamed).size(), 2U) << "one without a name needs no label";
}

}  // namespace
}  // namespace ricochet::report
