#include "src/research/calibration/variants/height_count.h"

#include <gtest/gtest.h>

#include "ricochet/recording.h"

namespace ricochet::studies::variants {
namespace {

using carrier_track::Wall;

/// A gap of 4 mm; impacts count from 1 cm/s on.
carrier_track::Scene gap_of_4_mm() {
  carrier_track::Scene scene;
  scene.wall_upper = 4e-3;
  scene.counting_limit = 0.01;
  return scene;
}

TEST(HeightCount, CountsFastHitsOnWallsWithinTheLimits) {
  const auto scene = gap_of_4_mm();
  for (const auto& [inner, count] : {std::pair{0.0, 2}, {1.5e-3, 1}, {-1.5e-3, 1}}) {
    HeightCount heard(scene, {inner, 3e-3, 1e-3}, 100);
    heard.impact(0.1, Wall::upper, 0.02);
    heard.impact(0.2, Wall::lower, 0.02);
    heard.impact(0.3, Wall::upper, 0.005);
    heard.impact(0.4, Wall::lower, 0.005);
    EXPECT_EQ(heard.count(), count) << inner;
  }
}

TEST(HeightCount, CountsTurnsBetweenTheWallsButNoSmallHops) {
  const auto scene = gap_of_4_mm();
  HeightCount heard(scene, {0, 3e-3, 1e-3}, 100);
  heard.peak(0.1, 3.5e-3);
  heard.valley(0.2, 0.5e-3);
  heard.peak(0.3, 2.5e-3);
  heard.valley(0.4, 1.5e-3);
  EXPECT_EQ(heard.count(), 2);
  heard.impact(0.5, Wall::upper, 0.02);
  heard.peak(0.5, 4e-3);  // the hit itself
  EXPECT_EQ(heard.count(), 3);
  heard.valley(0.6, 0.5e-3);
  EXPECT_EQ(heard.count(), 4);
  heard.impact(0.7, Wall::lower, 0.001);
  heard.peak(0.8, 3.5e-3);
  heard.valley(0.9, 0.5e-3);
  EXPECT_EQ(heard.count(), 4);
}

TEST(HeightCount, EndsWithTheFirstThatIsOfNoInterest) {
  const auto scene = gap_of_4_mm();
  HeightCount heard(scene, {0, 3e-3, 1e-3}, 1);
  heard.impact(0.1, Wall::upper, 0.02);
  EXPECT_THROW(heard.impact(0.2, Wall::upper, 0.02), StoppedEarly);
  EXPECT_EQ(heard.count(), 2);
}

}  // namespace
}  // namespace ricochet::studies::variants
