#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/motion/planar_model.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

/// A direction 1 m wide with friction 0.5 p beside the steady one.
PlanarAxis<> axis_of(const Scene& scene, double steady_friction) {
  return PlanarAxis<>(AppliedForces<double>(scene),
                      {0, 1, 0.5, 0.5, scene.start_position, scene.start_velocity},
                      {0.5, steady_friction}, 10.0, resting_speed);
}

/// One where nothing ever happens.
PlanarAxis<> still() {
  return axis_of(Scene{}, 0);
}

Observer nobody;

TEST(PlanarAxis, ComesToItsWallWhenAFlightDoesAndReturnsTheImpulse) {
  Scene scene;
  scene.start_velocity = 2;
  PlanarAxis<> axis = axis_of(scene, 0);
  axis.go_on(0, still(), nobody);
  ASSERT_EQ(axis.next(), 0.25);
  EXPECT_EQ(axis.reach(0.2, nobody), 0) << "nothing happens yet";
  EXPECT_EQ(axis.reach(0.25, nobody), 1.5 * 2);
  axis.go_on(0.25, still(), nobody);
  EXPECT_EQ(axis.next(), 1.25);
}

TEST(PlanarAxis, AnImpulseSlowsItByTheCoefficientAndNoFurtherThanToRest) {
  for (const double impulse : {1.0, 7.0}) {
    Scene scene;
    scene.start_velocity = -2;
    PlanarAxis<> axis = axis_of(scene, 0);
    axis.go_on(0, still(), nobody);
    axis.apply_friction_impulse(0.125, impulse, nobody);
    axis.go_on(0.125, still(), nobody);
    EXPECT_DOUBLE_EQ(axis.next(), impulse == 1.0 ? 0.125 + 0.25 / 1.5 : infinity);
    EXPECT_EQ(axis.finish(nobody).velocity == 0, impulse == 7.0);
  }
}

TEST(PlanarAxis, AnImpulseDoesNotMoveItFromRest) {
  PlanarAxis<> axis = still();
  axis.go_on(0, still(), nobody);
  axis.apply_friction_impulse(0.5, 3.0, nobody);
  EXPECT_FALSE(axis.go_on(0.5, still(), nobody));
  EXPECT_EQ(axis.next(), infinity);
}

TEST(PlanarAxis, TellsWhenItsPressEndsAndWhenItDeparts) {
  // Pressed to the lower wall by cos(2 t), held by friction up to 0.6 away from it.
  Scene scene;
  scene.start_position = 0;
  scene.pull = 1;
  scene.pull_rotates = true;
  scene.omega = 2;
  PlanarAxis<> axis = axis_of(scene, 0.6);
  PlanarAxis other = still();
  axis.go_on(0, other, nobody);
  EXPECT_TRUE(other.go_on(0, axis, nobody));
  EXPECT_FALSE(other.go_on(0, axis, nobody));
  EXPECT_NEAR(axis.next(), pi / 4, 1e-14);
  EXPECT_EQ(axis.reach(axis.next(), nobody), 0);
  EXPECT_TRUE(other.go_on(pi / 4, axis, nobody)) << "the press has ended";
  EXPECT_NEAR(axis.next(), std::acos(-0.6) / 2, 1e-14);
  axis.reach(axis.next(), nobody);
  axis.go_on(axis.next(), other, nobody);
  EXPECT_FALSE(other.go_on(axis.next(), axis, nobody)) << "nothing pressed it any more";
}

TEST(PlanarAxis, IsHeldWhereForceAndFrictionBalanceButForRounding) {
  // A press of 0.1 i - 0.1 k gives friction of half that, which the pull equals in decimals.
  for (int i = 2; i < 30; ++i) {
    for (int k = 1; k < i; ++k) {
      for (const double mass : {1.0, 1.2, 3.0}) {
        Scene pressed;
        pressed.mass = mass;
        pressed.omega = pressed.disturbance_frequency = 0;
        pressed.start_position = 1;
        pressed.pull = -0.1 * i;
        pressed.disturbance = -0.1 * k;
        PlanarAxis other = axis_of(pressed, 0);
        Scene scene;
        scene.mass = mass;
        scene.omega = 0;
        scene.pull = 0.05 * (i - k);
        PlanarAxis<> axis = axis_of(scene, 0);
        other.go_on(0, axis, nobody);
        axis.go_on(0, other, nobody);
        EXPECT_EQ(axis.finish(nobody).velocity, 0);
      }
    }
  }
}

TEST(PlanarAxis, TellsWhenItsPressBeginsAgain) {
  // As before, but for friction that holds it through the pull's whole turn.
  Scene scene;
  scene.start_position = 0;
  scene.pull = 1;
  scene.pull_rotates = true;
  scene.omega = 2;
  PlanarAxis<> axis = axis_of(scene, 1.5);
  axis.go_on(0, still(), nobody);
  for (int turn = 0; turn < 6; ++turn) {
    EXPECT_NEAR(axis.next(), pi / 4 + turn * pi / 2, 1e-13);
    axis.reach(axis.next(), nobody);
  }
  EXPECT_EQ(axis.next(), infinity);
}

}  // namespace
}  // namespace ricochet::carrier_track
