#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "src/studies/machine/charts.h"

namespace ricochet::studies {
namespace {

using namespace carrier_track;

/// Bounces between elastic walls 1 m apart at 2 m/s.
Scene bouncing() {
  Scene scene;
  scene.start_velocity = 2;
  scene.omega = 3;
  scene.window = Seconds{1.5};
  return scene;
}

TEST(PathChart, ShowsMillimetresOverSeconds) {
  const Scene scene = bouncing();
  const report::Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
  report::check(chart);
  EXPECT_EQ(chart.x.label, "time [s]");
  ASSERT_EQ(chart.series.size(), 2U);
  const auto& samples = chart.series[0].samples;
  EXPECT_EQ(samples.front().position, 0);
  EXPECT_EQ(samples.front().value, 500);
  EXPECT_NEAR(samples.back().position, 1.5, 1e-12);
  ASSERT_EQ(chart.lines.size(), 2U);
  EXPECT_EQ(chart.lines[1].position, 1000);
}

TEST(PathChart, CountsTurnsWhereTheWindowDoes) {
  Scene scene = bouncing();
  scene.window = Revolutions{0.75};
  const report::Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
  EXPECT_EQ(chart.x.label, "driver plate [turns]");
  EXPECT_NEAR(chart.series[0].samples.back().position, 0.75, 1e-12);
}

TEST(PathChart, MarksWhatTheRuleCounts) {
  Scene scene = bouncing();
  scene.pull = 20;  // falls back from its first summit
  const auto marks_of = [&] {
    const report::Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
    report::check(chart);
    return chart.series.at(1);
  };
  const report::Series impacts = marks_of();
  EXPECT_EQ(impacts.label, "impact that counts");
  ASSERT_FALSE(impacts.samples.empty());
  for (const report::Sample& mark : impacts.samples) EXPECT_EQ(mark.value, 0) << "lower wall";
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.55;
  scene.peak_low = 0.1;
  const report::Series maxima = marks_of();
  EXPECT_EQ(maxima.label, "maximum that counts");
  ASSERT_FALSE(maxima.samples.empty());
  for (const report::Sample& mark : maxima.samples) {
    EXPECT_NEAR(*mark.value, 1e3 * (0.5 + 2.0 * 2.0 / (2 * 20)), 1e-6) << "the summit";
  }
}

TEST(PathChart, ZoomsWhereMostHappens) {
  Scene scene;  // falls on the lower wall, and rests there from about 0.15 s on
  scene.start_position = 0.05;
  scene.restitution_lower = 0.5;
  scene.pull = 40;
  scene.window = Seconds{5};
  const Recording recording = record(scene, 0.25, 100);
  const auto chart = zoom_chart(scene, recording);
  ASSERT_TRUE(chart);
  report::check(*chart);
  EXPECT_GE(chart->x.range->lower, 0);
  EXPECT_LT(chart->x.range->upper, 0.3);
  const auto& path = chart->series.at(0).samples;
  EXPECT_GT(path.size(), 1000U);
  double highest = 0;
  for (const report::Sample& sample : path) {
    EXPECT_GE(sample.position, chart->x.range->lower);
    EXPECT_LE(sample.position, chart->x.range->upper);
    highest = std::max(highest, *sample.value);
  }
  EXPECT_LT(highest, chart->y.range->upper);
  EXPECT_LT(chart->y.range->upper, 60);
  ASSERT_EQ(chart->lines.size(), 1U) << "the upper wall is far away";
  EXPECT_EQ(chart->lines[0].position, 0);
  EXPECT_GE(3 * chart->series.at(1).samples.size(), 2 * static_cast<std::size_t>(recording.count));
  EXPECT_FALSE(zoom_chart(bouncing(), record(bouncing(), 0.25, 100)));
}

TEST(PathChart, DrawsNoWallAtInfinity) {
  Scene scene = bouncing();
  scene.wall_upper = std::numeric_limits<double>::infinity();
  const report::Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
  report::check(chart);
  EXPECT_EQ(chart.lines.size(), 1U);
  EXPECT_FALSE(chart.y.range.has_value());
}

}  // namespace
}  // namespace ricochet::studies
