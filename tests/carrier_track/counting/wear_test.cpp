#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

/// A ball of 2 kg thrown from a floor at 3 m/s under 9.81 m/s^2, without friction.
Scene falling_ball(double restitution) {
  Scene scene;
  scene.mass = 2.0;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.start_position = 0.0;
  scene.start_velocity = 3.0;
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.pull = 2.0 * 9.81;
  scene.window = Seconds{10.0};
  return scene;
}

TEST(Wear, OfABallThatComesToRestIsAllItsEnergy) {
  EXPECT_NEAR(wear(falling_ball(0.5)), 1e3 * 0.5 * 2.0 * 9.0, 1e-8);
}

TEST(Wear, OfOneImpactIsWhatTheRestitutionLeaves) {
  Scene scene = falling_ball(0.5);
  scene.window = Seconds{0.8};  // it comes back after 0.61 s, and again 0.31 s later
  EXPECT_NEAR(wear(scene), 1e3 * 0.5 * 2.0 * 9.0 * (1 - 0.25), 1e-9);
}

TEST(Wear, FadesToTheEndOfTheWindow) {
  Scene scene = falling_ball(0.5);
  const double time = 2 * 3.0 / 9.81;
  const double whole = 1e3 * 0.5 * 2.0 * 9.0 * (1 - 0.25);
  scene.window = Seconds{time * (1 + 1e-9)};
  EXPECT_LT(wear(scene), 1e-9 * whole);
  scene.window = Seconds{time / (1 - 0.1 * wear_smoothing)};
  EXPECT_NEAR(wear(scene), whole * (1 - std::exp(-1.0)), 1e-9 * whole);
}

TEST(Wear, OfElasticWallsIsNone) {
  EXPECT_EQ(wear(falling_ball(1.0)), 0.0);
}

/// The two walls of a slot lose what each returns.
TEST(Wear, GoesByTheRestitutionOfTheWall) {
  Scene scene;
  scene.mass = 1.0;
  scene.start_velocity = 1.0;
  scene.restitution_upper = 0.5;
  scene.restitution_lower = 0.2;
  scene.window = Seconds{2.0};  // up after 0.5 s, down 2 s later
  EXPECT_NEAR(wear(scene), 1e3 * 0.5 * 0.75, 1e-9);
  scene.window = Seconds{3.0};
  EXPECT_NEAR(wear(scene), 1e3 * 0.5 * (0.75 + 0.25 * (1 - 0.04)), 1e-9);
}

TEST(Wear, HasWhatFrictionInContactTakesInIt) {
  Scene scene = falling_ball(1.0);
  scene.contact_friction = true;
  scene.friction = 0.6;  // sqrt(0.4 / 1.6) = 0.5 of the speed is left
  scene.window = Seconds{0.8};
  EXPECT_NEAR(wear(scene), 1e3 * 0.5 * 2.0 * 9.0 * (1 - 0.25), 1e-9);
}

TEST(Wear, ShowsTheSimulationToAnother) {
  struct Counter : Observer {
    void impact(const double& /*time*/, Wall /*wall*/, const double& /*speed*/) { ++impacts; }
    int impacts = 0;
  } counter;
  Scene scene = falling_ball(0.5);
  scene.window = Seconds{0.7};
  wear(scene, counter);
  EXPECT_EQ(counter.impacts, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
