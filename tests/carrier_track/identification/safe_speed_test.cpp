#include <gtest/gtest.h>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

/// Collisions per turn in steady motion, by a long window that begins after the start's decay.
double per_turn(Scene scene, double omega) {
  scene = at_speed(scene, omega);
  scene.start_position = 0.3e-3;
  scene.start_velocity = 0;
  scene.window = Revolutions{40};
  const int all = counts(scene, std::vector<double>{omega}).front();
  scene.window = Revolutions{20};
  return (all - counts(scene, std::vector<double>{omega}).front()) / 20.0;
}

TEST(SafeSpeed, IsTheLastWithTwoCollisionsATurn) {
  const std::optional<double> safe = safe_speed(knocking_machine());
  ASSERT_TRUE(safe);
  EXPECT_EQ(per_turn(knocking_machine(), 0.9999 * *safe), 2);
  EXPECT_GT(per_turn(knocking_machine(), 1.0001 * *safe), 2);
}

TEST(SafeSpeed, IsMissingWhereEverySpeedIsSafe) {
  Scene quiet = knocking_machine();
  quiet.restitution_lower = quiet.restitution_upper = 0;
  EXPECT_FALSE(safe_speed(quiet, 10));
}

TEST(SafeSpeed, IsMissingWhereNoSpeedIsSafe) {
  Scene loud = knocking_machine();
  loud.friction = 0;
  loud.pull = 0;
  loud.restitution_lower = loud.restitution_upper = 0.9;
  loud.counting_limit = 1e-6;
  EXPECT_GT(per_turn(loud, 0.05), 2);
  EXPECT_FALSE(safe_speed(loud, 10));
}

}  // namespace
}  // namespace ricochet::carrier_track
