#include <gtest/gtest.h>

#include "src/report/frame.h"

namespace ricochet::report {
namespace {

constexpr double height = 200;  // pixels

/// Two curves that end at 1 and at the value.
Chart two_curves(double value) {
  Chart chart;
  chart.name = "two";
  chart.title = "Two";
  chart.x = {.label = "x", .range = Range{0, 10}};
  chart.y = {.label = "y", .range = Range{0, 10}};
  chart.series = {{"low", Mark::line, {{0, 5}, {10, 1}}},
                  {"high", Mark::steps, {{0, 5}, {10, value}}}};
  return chart;
}

std::vector<EndLabel> labels_of(const Chart& chart) {
  return end_labels(chart, *chart.x.range, *chart.y.range, height);
}

std::size_t number_for(const Chart& chart) {
  return labels_of(chart).size();
}

TEST(EndLabels, StandWhereCurvesEndApart) {
  const auto labels = labels_of(two_curves(9));
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[1].text, "high");
  EXPECT_NEAR(labels[1].place, 0.9, 1e-12);
}

TEST(EndLabels, LeaveTheLegendWhereThereAreManyOrTheyWouldBeFar) {
  Chart many = two_curves(9);
  for (int i = 2; i < 6; ++i) {
    many.series.push_back({"more", Mark::line, {{0, 5}, {10, 1.5 * i}}});
  }
  EXPECT_EQ(number_for(many), 6U);
  many.series.push_back({"one too many", Mark::line, {{0, 5}, {10, 5}}});
  EXPECT_EQ(number_for(many), 0U);
  Chart far = two_curves(1);
  for (int i = 0; i < 4; ++i) far.series.push_back({"too", Mark::line, {{0, 5}, {10, 0}}});
  EXPECT_EQ(number_for(far), 0U);  // the highest of six at the bottom is 70 pixels from its curve
}

TEST(EndLabels, AreMovedApartAndLedTo) {
  const Chart chart = two_curves(1.5);
  const auto labels = labels_of(chart);
  ASSERT_EQ(labels.size(), 2U);
  // A plot is 200 pixels high: both give way by the same.
  EXPECT_NEAR(labels[0].place, 0.125 - 7.0 / 200, 1e-12);
  EXPECT_NEAR(labels[1].place, 0.125 + 7.0 / 200, 1e-12);
  EXPECT_FALSE(need_leaders(labels, height));  // by 2 pixels
  Chart close = two_curves(1.1);
  close.series.push_back({"third", Mark::line, {{0, 5}, {10, 1.2}}});
  const auto led = labels_of(close);
  ASSERT_EQ(led.size(), 3U);
  EXPECT_NEAR(led[2].place - led[1].place, 14.0 / 200, 1e-12);
  EXPECT_TRUE(need_leaders(led, height));
  // Where the plot ends they do, too.
  Chart low = two_curves(0.1);
  low.series[0].samples.back().value = 0;
  const auto lowest = labels_of(low);
  ASSERT_EQ(lowest.size(), 2U);
  EXPECT_EQ(lowest[0].place, 0);
  EXPECT_NEAR(lowest[1].place, 14.0 / 200, 1e-12);
}

TEST(EndLabels, AreOfAllCurvesOrOfNone) {
  Chart early = two_curves(9);
  early.series[0].samples.back().position = 8;
  EXPECT_EQ(number_for(early), 0U);
  Chart gap = two_curves(9);
  gap.series[0].samples.back().value.reset();
  EXPECT_EQ(number_for(gap), 0U);
  EXPECT_EQ(number_for(two_curves(11)), 0U);
  Chart points = two_curves(9);
  points.series[1].mark = Mark::points;
  EXPECT_EQ(number_for(points), 0U);
  Chart wide = two_curves(9);
  wide.series[0].label = std::string(80, 'w');
  EXPECT_EQ(number_for(wide), 0U);
  Chart one = two_curves(9);
  one.series.pop_back();
  EXPECT_EQ(number_for(one), 0U);
  Chart unnamed = two_curves(9);
  unnamed.series.push_back({"", Mark::line, {{0, 0}, {5, 5}}});
  EXPECT_EQ(number_for(unnamed), 2U);
}

}  // namespace
}  // namespace ricochet::report
