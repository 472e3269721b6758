#include <gtest/gtest.h>

#include <limits>

#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track {
namespace {

TEST(Clearance, GrowsFromTheLowerWallAndTakesTheStartAlong) {
  Scene scene;
  scene.wall_lower = 1.0;
  scene.wall_upper = 3.0;
  scene.start_position = 1.5;  // a quarter of the way
  const Scene wider = scaled_clearance(2.0, scene);
  EXPECT_EQ(wider.wall_lower, 1.0);
  EXPECT_EQ(wider.wall_upper, 5.0);
  EXPECT_EQ(wider.start_position, 2.0);
}

TEST(Clearance, WithoutAnUpperWallStaysWithout) {
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  EXPECT_EQ(scaled_clearance(0.9, scene).wall_upper, scene.wall_upper);
}

}  // namespace
}  // namespace ricochet::carrier_track
