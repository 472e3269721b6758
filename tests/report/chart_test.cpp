#include "src/report/chart.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "src/report/ticks.h"
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
  chart.x.label = "question";
  EXPECT_EQ(description(chart), "Heat map of solved [%] over question.");
  chart.y.label = "solver";
  EXPECT_EQ(description(chart), "Heat map of solved [%] over question and solver.");
}

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) result.push_back(tick.label);
  return result;
}

TEST(Ticks, AreRound) {
  EXPECT_DOUBLE_EQ(tick_step({-0.42, 0.41}, 5, false), 0.2);
  EXPECT_DOUBLE_EQ(tick_step({0, 1000}, 2, false), 500);
  EXPECT_DOUBLE_EQ(tick_step({0, 999}, 1, false), 1000);
}

TEST(Ticks, OfWholeNumbersHaveNoFractions) {
  EXPECT_EQ(tick_step({-0.1, 2.1}, 8, true), 1);
}

TEST(Ticks, OfManyDecadesArePowersOfTen) {
  EXPECT_THAT(labels(logarithmic_ticks({1e-6, 1e-2}, 3)), ElementsAre("10⁻⁶", "10⁻⁴", "10⁻²"));
}

TEST(Ticks, OfLessThanTwoDecadesShowTwoAndFiveToo) {
  EXPECT_THAT(labels(logarithmic_ticks({1, 20}, 5)), ElementsAre("1", "2", "5", "10", "20"));
}

TEST(Limits, HaveRoomAroundASingleValue) {
  EXPECT_LT(limits({3}, Scale::linear).lower, 3);
  EXPECT_GT(limits({3}, Scale::logarithmic).upper, 3);
  EXPECT_LT(limits({0}, Scale::linear).lower, 0);
}

}  // namespace
}  // namespace ricochet::report
