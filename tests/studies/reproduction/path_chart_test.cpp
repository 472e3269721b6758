#include "src/studies/reproduction/path_chart.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet::studies::reproduction {
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
  ASSERT_EQ(chart.series.size(), 1U);
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

TEST(PathChart, DrawsNoWallAtInfinity) {
  Scene scene = bouncing();
  scene.wall_upper = std::numeric_limits<double>::infinity();
  const report::Chart chart = path_chart(scene, record(scene, 0.25, 100), "path", "title");
  report::check(chart);
  EXPECT_EQ(chart.lines.size(), 1U);
  EXPECT_FALSE(chart.y.range.has_value());
}

}  // namespace
}  // namespace ricochet::studies::reproduction
