#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track {
namespace {

Scene resting() {
  Scene scene;
  scene.mass = 1.2;
  scene.wall_upper = 0.8e-3;
  scene.start_position = 0;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.friction = 0.2;
  scene.normal_force = 11.8;
  scene.centrifugal_mass_radius = 0.078;
  scene.window = Revolutions{40};
  return scene;
}

/// Returns true if the carrier still turns or hits a wall in the second half of the window.
bool keeps_moving(const Scene& scene, double omega) {
  const Recording recording = record(at_speed(scene, omega), 0.25, 0);
  const auto is_late = [&](const auto& events) {
    return !events.empty() && events.back().time > 125 / omega;
  };
  return is_late(recording.impacts) || is_late(recording.peaks);
}

TEST(Release, FollowsTheHandFormula) {
  EXPECT_NEAR(release_speed(resting()).value(), std::sqrt(0.2 * 11.8 / 0.078), 1e-12);
  Scene scene = resting();
  scene.slider_mass_radius = 0.02;  // against the carrier's
  scene.pull = 0.5;
  EXPECT_NEAR(release_speed(scene).value(), std::sqrt((0.2 * 11.8 + 0.5) / 0.058), 1e-12);
  scene.disturbance = 0.3;
  EXPECT_NEAR(release_speed(scene).value(), std::sqrt((0.2 * 11.8 + 0.2) / 0.058), 1e-12);
}

TEST(Release, IsWhereTheCarrierBeginsToMove) {
  Scene pulled = resting();
  pulled.pull = -0.7;  // to the upper wall
  Scene turning = resting();
  turning.pull = 0.7;
  turning.pull_rotates = true;
  turning.pull_phase = 2.0;
  Scene pressed = resting();
  pressed.centrifugal = Centrifugal::outward;
  pressed.centrifugal_mass_radius = 0.01;
  pressed.slider_mass_radius = 0.05;
  for (const Scene& scene : {resting(), pulled, turning, pressed}) {
    const double release = release_speed(scene).value();
    EXPECT_FALSE(keeps_moving(scene, 0.999 * release)) << release;
    EXPECT_TRUE(keeps_moving(scene, 1.001 * release)) << release;
  }
}

TEST(Release, IsAtOnceOrNever) {
  Scene scene = resting();
  scene.disturbance = 3;
  EXPECT_EQ(release_speed(scene), 0.0);
  scene.disturbance_frequency = 0;  // then it presses
  EXPECT_GT(release_speed(scene).value(), 5);
  scene.centrifugal = Centrifugal::inward;
  EXPECT_FALSE(release_speed(scene).has_value());
}

TEST(Release, ThrowsTheCarrierAcrossTheClearance) {
  Scene scene = resting();
  EXPECT_EQ(thrown_speed(scene, 5), 0);
  EXPECT_NEAR(thrown_speed(scene, 10), std::sqrt(2 * (7.8 - 2.36) * 0.8e-3 / 1.2), 1e-12);
  scene.wall_upper = std::numeric_limits<double>::infinity();
  EXPECT_EQ(thrown_speed(scene, 10), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ricochet::carrier_track
