#include "src/studies/surrogate/study.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;
using testing::HasSubstr;

TEST(SurrogateStudy, FillsItsPageAndDrawsItsCharts) {
  report::Json data = surrogate_study().compute(true);
  data["made"] = {{"version", "1.2.3"},
                  {"compiler", "GCC"},
                  {"threads", 2},
                  {"seconds", 4.5},
                  {"date", "2026-01-01"}};
  const report::Results results = report::results_of(data);
  const auto page = report::page_source(report::page_template("surrogate"));
  const report::PageFiles written = page_files(page, results);
  EXPECT_TRUE(written.failures.empty());
  for (const char* chart : {"speed-gap.svg", "validity-trend.svg"}) {
    EXPECT_TRUE(written.files.contains(chart)) << chart;
  }
  const std::string text = written.files.at("summary.md");
  for (const char* section : {"## How large is the surrogate's bias?", "## Is the surrogate cont",
                              "## Where does the gradient mean", "## Are the derivatives right?"}) {
    EXPECT_THAT(text, HasSubstr(section));
  }
  for (const Table& table : results.tables) {
    EXPECT_TRUE(table.name == "unexplained" || !table.rows.empty()) << table.name;
  }
  EXPECT_THAT(terminal_text(page, results), HasSubstr("At smoothing parameter 0.25"));
}

TEST(Bias, KnowsTheBestOfTheCountAndClosesAsTheSmoothingGoesToZero) {
  const Table table = bias(0.25, {1.0, 1e-7});
  const auto machines = all_machines();
  ASSERT_EQ(table.rows.size(), 2 * machines.size());
  for (std::size_t c = 0; c < machines.size(); ++c) {
    const auto scan = scan_speeds(machines[c].scene, 0.25, 18);
    std::size_t last = scan.counts.size() - 1;
    while (scan.counts[last] > machines[c].quiet_limit) --last;
    EXPECT_EQ(table[2 * c].number("fastest"), scan.omega(last)) << machines[c].id;
    const Row closed = table[2 * c + 1];
    EXPECT_EQ(closed.number("speed_optimality_gap"), 0.0) << machines[c].id;
    EXPECT_EQ(closed.number("count_optimality_gap"), 0) << machines[c].id;
    EXPECT_TRUE(closed.is("quiet")) << machines[c].id;
  }
  EXPECT_LT(table[0].number("speed_optimality_gap"), -1) << "C1, where the surrogate is wide";
}

/// A case that is truly quiet up to 5 rad/s, at two smoothing parameters.
void add_case(Table& table, const char* id, double wide, double narrow) {
  for (const auto& [smoothing, speed] : {std::pair(0.25, wide), std::pair(0.001, narrow)})
    table.add(id, 5, smoothing, speed, 5 - speed, speed <= 5, 0);
}

TEST(Bias, SaysHowFarTheFastestQuietSpeedIsOff) {
  Table table{"bias", columns_named("case,fastest,smoothing,speed,speed_optimality_gap,quiet,"
                                    "count_optimality_gap")};
  add_case(table, "A", 6, 5);
  add_case(table, "B", 8, 5.02);
  add_case(table, "C", 4.5, 5);
  report::Results results;
  add_bias(results, table, 0.01);
  // |5 - 6|, |5 - 8| and |5 - 4.5|: the median is 1, the largest 3, and two are too fast.
  const std::string finding = text_of(*results.value("finding"));
  EXPECT_THAT(finding, HasSubstr("off by 1.00 rad/s in the median of 3 cases, by 3.00 at worst, "
                                 "and truly loud in 2;"));
  EXPECT_THAT(finding, HasSubstr("at 0.001 it is off by 0.00 and 0.02 rad/s, but still truly loud "
                                 "in 1."));
  EXPECT_EQ(*results.value("too-fast"), value_of(3));
  EXPECT_EQ(*results.value("too-slow"), value_of(1));
  const Table& speeds = *results.table("quiet-speeds");
  EXPECT_EQ(speeds[1].number("at_0.25"), 8);
  EXPECT_EQ(speeds[1].number("fastest"), 5);
  EXPECT_EQ(results.chart("speed-gap")->series.size(), 3U);
}

TEST(Gradients, CountEveryPointOnceAndAreFlatNextToTheCount) {
  const Table table = gradients({0.25, 1e-7}, 6, 4);
  ASSERT_EQ(table.rows.size(), 12U * 6 * 4 * 2);
  each_row(table, [](const Row& row) {
    EXPECT_EQ(row.is("right") + row.is("wrong") + row.is("neither"), 1);
    EXPECT_TRUE(!row.is("flat") || row.is("neither"));
  });
  report::Results results;
  add_gradients(results, table);
  const Table& validity = *results.table("validity");
  EXPECT_LT(validity[0].number("flat"), 0.2);
  EXPECT_GT(validity[1].number("flat"), 0.95);
  EXPECT_EQ(results.chart("validity-trend")->heat_map->rows.size(), 12U);
}

TEST(Gradients, CountPointsWithoutATrendAmongAll) {
  Table table{"gradients",
              columns_named("smoothing,case,speed,flat,kink,sensitive,right,wrong,neither")};
  for (int k = 0; k < 10; ++k)
    table.add(0.25, "C1", 9.0, false, false, false, k < 3, k >= 3 && k < 6, k >= 6);
  table.add(0.25, "C1", 12.0, true, false, false, false, false, true);
  report::Results results;
  add_gradients(results, table);
  const Row row = (*results.table("validity"))[0];
  EXPECT_DOUBLE_EQ(row.number("right"), 3.0 / 11);
  EXPECT_DOUBLE_EQ(row.number("wrong"), 3.0 / 11);
  EXPECT_DOUBLE_EQ(row.number("no_trend"), 5.0 / 11);
  const auto& cells = results.chart("validity-trend")->heat_map->rows.at(0);
  EXPECT_EQ(cells, (std::vector<std::optional<double>>{50, std::nullopt}));
}

/// Drifts from x = 0.5 m at 0.1 m/s and swings by 0.5 m about that, so that it first turns at some
/// 1.5 m + 0.1 m/s pi / omega: the faster, the lower. The second swing hits the wall in
/// any case, about as fast as the counting limit.
Scene swing() {
  Scene scene;
  scene.centrifugal_mass_radius = 0.5;
  scene.start_position = 0.5;
  scene.start_velocity = 0.1;
  scene.wall_upper = 1.6;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.counting_limit = 1.3;
  scene.window = Revolutions{2};
  return scene;
}

/// [m] of the swing's top over the wall at a speed [rad/s].
double overshoot(double omega) {
  // x = 0.5 + 0.1 t + 0.5 (1 - cos(omega t)), first at rest where sin(omega t) = -0.2 / omega.
  const double angle = std::numbers::pi + std::asin(0.2 / omega);
  return 0.5 + 0.1 * angle / omega + 0.5 * (1 - std::cos(angle)) - 1.6;
}

/// What the page says of a graze, and that the gradient's reach is the distance from it.
TEST(Gradients, GrowWithTheInverseRootOfTheDistanceFromAGraze) {
  double grazing = 1, missed = 10;
  while (missed - grazing > 1e-14) {
    const double middle = 0.5 * (grazing + missed);
    (overshoot(middle) > 0 ? grazing : missed) = middle;
  }
  const auto slope = [&](double distance) {
    return surrogate_slope(at_speed(swing(), grazing - distance * 18), 0.25, 18);
  };
  const double far = slope(1e-7).slope, near = slope(1e-9).slope;
  EXPECT_NEAR(near / far, 10, 0.5);
  EXPECT_NEAR(slope(-1e-9).slope, slope(-1e-7).slope, 1e-2 * std::abs(slope(-1e-7).slope));
  for (const double distance : {1e-7, 1e-9, -1e-7, -1e-9})
    EXPECT_NEAR(slope(distance).trust.reach / std::abs(distance), 1, 1e-2);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
