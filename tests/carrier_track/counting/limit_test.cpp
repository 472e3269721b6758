#include "problems/carrier_track/counting/limit.h"

#include <gtest/gtest.h>

#include <numbers>

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

TEST(Limit, CountsTurnsOfBothKindsOfWindow) {
  EXPECT_NEAR(turns_of(shuttle()), 10, 1e-12);
  Scene scene = shuttle();
  scene.window = Revolutions{1.5};
  EXPECT_NEAR(turns_of(scene), 1.5, 1e-12);
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
  // The centrifugal force beats friction from 10 rad/s on: one throw, and an inelastic end.
  Scene scene;
  scene.start_position = 0.5;
  scene.restitution_lower = scene.restitution_upper = 0;
  scene.friction = 0.2;
  scene.normal_force = 500;
  scene.centrifugal = Centrifugal::outward;
  scene.centrifugal_mass_radius = 1;
  scene.window = Seconds{10};
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
