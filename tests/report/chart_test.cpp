#include "src/report/chart.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/report/frame.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

auto refuses(const Chart& chart) {
  return [chart] { check(chart); };
}

TEST(Chart, AcceptsGaps) {
  EXPECT_NO_THROW(check(line_chart({{0, 1}, {1, {}}, {2, 3}})));
}

TEST(Chart, RefusesZeroOnALogarithmicAxisAndSaysWhere) {
  Chart chart = line_chart({{1, 2.0}, {2, 0.0}});
  chart.y.scale = Scale::logarithmic;
  EXPECT_THAT(refuses(chart),
              ThrowsMessage<std::invalid_argument>(AllOf(
                  HasSubstr("\"path\", sample 1"), HasSubstr("> 0 on the logarithmic axis"))));
}

TEST(Chart, RefusesABandThatLeavesALogarithmicAxis) {
  Chart chart = line_chart({{1, 2.0, Range{-1, 3}}});
  chart.y.scale = Scale::logarithmic;
  EXPECT_THAT(refuses(chart), ThrowsMessage<std::invalid_argument>(HasSubstr("-1 must be > 0")));
}

TEST(Chart, RefusesNumbersThatAreNotFinite) {
  EXPECT_THROW(check(line_chart({{0, std::numeric_limits<double>::quiet_NaN()}})),
               std::invalid_argument);
  EXPECT_THROW(check(line_chart({{std::numeric_limits<double>::infinity(), 1}})),
               std::invalid_argument);
}

TEST(Chart, RefusesNumbersWhoseDifferencesCouldOverflow) {
  EXPECT_THAT(refuses(line_chart({{0, -1e101}})),
              ThrowsMessage<std::invalid_argument>(HasSubstr("beyond 1e100")));
  Chart chart = line_chart({{1e-301, 1}});
  chart.x.scale = Scale::logarithmic;
  EXPECT_THAT(refuses(chart), ThrowsMessage<std::invalid_argument>(HasSubstr("below 1e-300")));
}

TEST(Chart, RefusesASizeThatIsNone) {
  Chart chart = line_chart({{0, 1}});
  chart.height = 0;
  EXPECT_THAT(refuses(chart), ThrowsMessage<std::invalid_argument>(HasSubstr("480 x 0 pixels")));
}

TEST(Chart, RefusesPositionsThatFallBack) {
  EXPECT_THROW(check(line_chart({{1, 1}, {0, 1}})), std::invalid_argument);
}

TEST(Chart, RefusesANameThatIsNoFileStem) {
  for (const char* name : {"", "a/b", "A", "a b"}) {
    Chart chart = line_chart({{0, 1}});
    chart.name = name;
    EXPECT_THROW(check(chart), std::invalid_argument) << name;
  }
}

TEST(Chart, RefusesAHeatMapWithARowTooShort) {
  EXPECT_THAT(refuses(heat_map_chart({{1, 2}, {3}})),
              ThrowsMessage<std::invalid_argument>(HasSubstr("1 cells for 2 categories of x")));
}

TEST(Chart, DescribesItselfByItsLabels) {
  Chart chart = line_chart({{0, 1}});
  chart.lines = {{Direction::horizontal, 0, "wall"}, {Direction::horizontal, 2, "wall"}};
  EXPECT_EQ(description(chart), "x [mm] against time [s]: path, wall.");
}

TEST(Chart, DescribesAHeatMapByTheAxesThatHaveAName) {
  Chart chart = heat_map_chart({{1, 2}});
  chart.x.label = chart.y.label = "";
  chart.heat_map = HeatMap{"solved [%]", {{1.0}}};
  EXPECT_EQ(description(chart), "Heat map of solved [%].");
  chart.x.label = "problem";
  EXPECT_EQ(description(chart), "Heat map of solved [%] over problem.");
  chart.y.label = "solver";
  EXPECT_EQ(description(chart), "Heat map of solved [%] over problem and solver.");
}

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) result.push_back(tick.label);
  return result;
}

TEST(Ticks, AreRound) {
  EXPECT_THAT(labels(linear_ticks({-0.42, 0.41}, 5, false)),
              ElementsAre("−0.4", "−0.2", "0", "0.2", "0.4"));
  EXPECT_THAT(labels(linear_ticks({0, 1000}, 2, false)), ElementsAre("0", "500", "1000"));
  EXPECT_THAT(labels(linear_ticks({0, 999}, 1, false)), ElementsAre("0"));
}

TEST(Ticks, OfWholeNumbersHaveNoFractions) {
  EXPECT_THAT(labels(linear_ticks({-0.1, 2.1}, 8, true)), ElementsAre("0", "1", "2"));
}

TEST(Ticks, AreFewHoweverNarrowTheLimits) {
  EXPECT_LE(linear_ticks({1e9, std::nextafter(1e9, 2e9)}, 5, false).size(), 11U);
}

TEST(Ticks, OfNarrowLogarithmicAxesAreThoseOfLinearOnes) {
  EXPECT_THAT(labels(logarithmic_ticks({101, 109}, 4)), ElementsAre("102", "104", "106", "108"));
}

TEST(NumberLabel, IsWhatAReaderWrites) {
  EXPECT_EQ(number_label(-0.5), "−0.5");
  EXPECT_EQ(number_label(2e6), "2000000");
  EXPECT_EQ(number_label(3e-7), "3×10⁻⁷");
  EXPECT_EQ(number_label(-1e20), "−10²⁰");
}

TEST(Ticks, OfManyDecadesArePowersOfTen) {
  EXPECT_THAT(labels(logarithmic_ticks({1e-6, 1e-2}, 3)), ElementsAre("10⁻⁶", "10⁻⁴", "10⁻²"));
}

TEST(Ticks, OfLessThanTwoDecadesShowTwoAndFiveToo) {
  EXPECT_THAT(labels(logarithmic_ticks({1, 20}, 5)), ElementsAre("1", "2", "5", "10", "20"));
  EXPECT_THAT(labels(logarithmic_ticks({21, 79}, 4)), ElementsAre("30", "50", "70"));
}

TEST(Limits, HaveRoomAroundASingleValue) {
  EXPECT_LT(limits({3}, Scale::linear).lower, 3);
  EXPECT_GT(limits({3}, Scale::logarithmic).upper, 3);
  EXPECT_LT(limits({0}, Scale::linear).lower, 0);
}

Chart area_chart() {
  Chart chart = line_chart({{0, 1}, {4, 5}});
  chart.areas = {{"few", 0.5, {{{0, {0, 1}}, {4, {0, 5}}}}, "2"},
                 {"irregular", std::nullopt, {{{0, {1, 6}}, {4, {5, 6}}}}}};
  return chart;
}

TEST(Chart, RefusesAreasThatCannotBePainted) {
  EXPECT_NO_THROW(check(area_chart()));
  Chart back = area_chart();
  back.areas[0].parts[0][0].position = 9;
  EXPECT_THAT(refuses(back),
              ThrowsMessage<std::invalid_argument>(HasSubstr("positions must rise")));
  Chart turned = area_chart();
  turned.areas[0].parts[0][0].between = {2, 1};
  EXPECT_THAT(refuses(turned), ThrowsMessage<std::invalid_argument>(HasSubstr("is not a range")));
  Chart empty = area_chart();
  empty.areas[0].parts.emplace_back();
  EXPECT_THAT(refuses(empty), ThrowsMessage<std::invalid_argument>(HasSubstr("has no edge")));
  Chart bright = area_chart();
  bright.areas[0].shade = 1.5;
  EXPECT_THAT(refuses(bright), ThrowsMessage<std::invalid_argument>(HasSubstr("shade")));
  Chart both = heat_map_chart({{1}});
  both.areas = area_chart().areas;
  EXPECT_THAT(refuses(both),
              ThrowsMessage<std::invalid_argument>(HasSubstr("areas and a heat map")));
}

TEST(Chart, LetsALineBeginAnewBehindAGap) {
  EXPECT_NO_THROW(check(line_chart({{1, 1}, {2, 2}, {2, {}}, {0, 3}, {1, 4}})));
}

}  // namespace
}  // namespace ricochet::report
