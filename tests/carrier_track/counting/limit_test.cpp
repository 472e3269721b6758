#include <gtest/gtest.h>

#include <numbers>

#include "problems/carrier_track/counting/count.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/counting/held_scene.h"

namespace ricochet::carrier_track {
namespace {

/// Between two walls a metre apart, 2 m/s, without a force: an impact each half second, the first
/// after a quarter.
Scene shuttle() {
  Scene scene;
  scene.mass = 3;
  scene.start_velocity = 2;
  scene.restitution_lower = scene.restitution_upper = 1;
  scene.window = Seconds{5};
  scene.omega = 4 * std::numbers::pi;
  return scene;
}

TEST(Limit, MeasuresWhatItSays) {
  Scene scene = shuttle();
  EXPECT_EQ(measured(scene, Measure::collisions), 10);
  EXPECT_NEAR(measured(scene, Measure::collisions_per_turn), 1, 1e-12);
  EXPECT_NEAR(measured(scene, Measure::impact_speed), 2, 1e-12);
  EXPECT_NEAR(measured(scene, Measure::energy), 0, 1e-12);
  scene.restitution_upper = 0.5;
  scene.window = Seconds{1};  // the first takes 3/4 of 6 J, long before the window ends
  EXPECT_NEAR(measured(scene, Measure::energy), 4.5, 1e-9);
  scene.start_velocity = 0;
  EXPECT_EQ(measured(scene, Measure::impact_speed), 0);
}

TEST(Limit, IsFirstBrokenWhereverTheScanEnds) {
  const Scene scene = held();  // up to 10 rad/s; then one throw, and an inelastic end
  const Limit limit{Measure::collisions, 0};
  for (const double highest : {11.0, 15.0, 30.0}) {
    const Split split = split_by(scene, limit, 0.01, highest);
    ASSERT_TRUE(split.first_loud);
    EXPECT_NEAR(*split.first_loud, 10.01, 0.011);
    EXPECT_NEAR(split.speed.value_or(0), *split.first_loud - 0.005, 1e-9);
    EXPECT_EQ(split.misclassified, 0);
  }
  EXPECT_FALSE(split_by(scene, limit, 0.01, 9).first_loud);
}

}  // namespace
}  // namespace ricochet::carrier_track
