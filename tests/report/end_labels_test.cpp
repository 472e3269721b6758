#include "src/report/end_labels.h"

#include <gmock/gmock.h>

#include "src/report/script.h"

namespace ricochet::report {
namespace {

using testing::HasSubstr;
using testing::Not;

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

std::size_t number_for(const Chart& chart) {
  return end_labels(chart, {*chart.x.range, *chart.y.range}).size();
}

TEST(EndLabels, StandWhereCurvesEndApart) {
  EXPECT_EQ(number_for(two_curves(9)), 2U);
  const std::string script = gnuplot_script(two_curves(9));
  EXPECT_THAT(script, HasSubstr("set label 'high' at graph 1, graph 0.9000 left"));
  EXPECT_THAT(script, HasSubstr("unset key"));
}

TEST(EndLabels, LeaveTheLegendWhereCurvesEndTogether) {
  Chart third = two_curves(1.1);
  third.series.push_back({"third", Mark::line, {{0, 5}, {10, 1.2}}});
  EXPECT_EQ(number_for(third), 0U);
  EXPECT_THAT(gnuplot_script(third), Not(HasSubstr("unset key")));
}

TEST(EndLabels, AreMovedApartALittle) {
  const Chart chart = two_curves(1.5);
  const auto labels = end_labels(chart, {*chart.x.range, *chart.y.range});
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].place, 0.1);
  EXPECT_NEAR(labels[1].place, 0.1 + 14.0 / 200, 1e-12);  // of a plot 200 pixels high
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
