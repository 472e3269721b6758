#include "problems/carrier_track/regimes/steady_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"
#include "tests/carrier_track/regimes/shaken_table.h"

namespace ricochet::carrier_track {
namespace {

TEST(SteadyMotion, OfABallOnAShakenTableIsTheClosedFormOrbit) {
  for (const double e : {0.2, 0.5, 0.8}) {
    const double strength = (shaken_table::fold_strength(e) + shaken_table::flip_strength(e)) / 2;
    Scene scene = shaken_table::on_orbit(e, strength);
    scene.start_velocity *= 1.02;  // settles on it
    const SteadyMotion motion = steady_motion(scene);
    ASSERT_TRUE(motion.settled);
    EXPECT_EQ(motion.turns, 1);
    EXPECT_EQ(motion.rest, Rest::never);
    ASSERT_EQ(motion.impacts.size(), 1U);
    const double speed = shaken_table::gravity * 2 * std::numbers::pi / scene.omega / (1 + e);
    EXPECT_NEAR(motion.impacts[0].speed / speed, 1, 1e-12);
    EXPECT_NEAR(motion.energy_per_turn(), (1 - e * e) * speed * speed, 1e-10 * speed * speed);
    EXPECT_NEAR(motion.determinant, e * e, 1e-10);
    EXPECT_TRUE(motion.stable());
  }
}

TEST(SteadyMotion, AgreesWithLongSimulations) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Scene machine = random_machine(seed);
    const double omega = MachineDraw(seed + 1000).even_logarithm(0.5, 18);
    const SteadyMotion motion = steady_motion(at_speed(machine, omega));
    if (!motion.settled) continue;
    const int observed = motion.turns * (60 / motion.turns);
    EXPECT_DOUBLE_EQ(motion.collisions_per_turn(),
                     collisions_in_the_long_run(motion.orbit, omega, 260, observed))
        << seed << " at " << omega;
    ++compared;
  }
  EXPECT_GT(compared, 120);
}

TEST(SteadyMotion, OnAWallRestErasesTheStart) {
  Scene machine = default_machine();
  machine.omega = 5;
  const SteadyMotion first = steady_motion(machine);
  ASSERT_TRUE(first.settled);
  EXPECT_EQ(first.rest, Rest::on_a_wall);
  EXPECT_EQ(first.collisions, 2);
  for (const double velocity : {-2.0, -0.1, 0.0, 0.3, 1.0}) {
    machine.start_velocity = velocity;
    const SteadyMotion other = steady_motion(machine);
    ASSERT_EQ(other.impacts.size(), first.impacts.size());
    for (std::size_t i = 0; i < first.impacts.size(); ++i) {
      EXPECT_NEAR(other.impacts[i].speed / first.impacts[i].speed, 1, 1e-10);
    }
  }
}

TEST(SteadyMotion, IsStillBelowTheRelease) {
  Scene machine = default_machine();
  machine.omega = 1;
  const SteadyMotion still = steady_motion(machine);
  EXPECT_TRUE(still.settled);
  EXPECT_EQ(still.rest, Rest::always);
  EXPECT_EQ(still.share_at_rest, 1);
  EXPECT_EQ(still.fastest_impact(), 0);
}

TEST(SteadyMotion, GlidesSlowlyToAWall) {
  // Just above the release a small pull moves the carrier by some 1e-8 m a turn.
  Scene machine = default_machine();
  machine.omega = 1.4176;
  machine.start_velocity = 0;
  const SteadyMotion motion = steady_motion(machine);
  ASSERT_TRUE(motion.settled);
  EXPECT_EQ(motion.orbit.start_position, machine.wall_lower);
  EXPECT_EQ(motion.rest, Rest::always);
}

TEST(SteadyMotion, StaysOnAnOrbitThatIsFollowed) {
  const double e = 0.5;
  const SteadyMotion stable = steady_motion(shaken_table::on_orbit(e, 1.5));
  // Beyond the flip the orbit is unstable, and still there.
  const double beyond = shaken_table::speed_at(1.03 * shaken_table::flip_strength(e));
  const SteadyMotion unstable = followed(stable, beyond);
  EXPECT_EQ(unstable.turns, 1);
  EXPECT_FALSE(unstable.stable());
  EXPECT_NEAR(unstable.impacts.at(0).speed,
              shaken_table::gravity * 2 * std::numbers::pi / beyond / (1 + e), 1e-12);
}

TEST(SteadyMotion, RepeatsWithTheDisturbanceWhereThatRepeats) {
  Scene machine = default_machine();
  machine.disturbance = 0.1;
  machine.disturbance_frequency = 1;
  machine.omega = 3;
  EXPECT_EQ(forcing_turns(machine), 3);
  machine.omega = 2.5;
  EXPECT_EQ(forcing_turns(machine), 5);
  machine.omega = 2.5123;
  EXPECT_EQ(forcing_turns(machine), 0);
  machine.omega = 3;
  const SteadyMotion motion = steady_motion(machine);
  ASSERT_TRUE(motion.settled);
  EXPECT_EQ(motion.turns, 3);
  EXPECT_EQ(motion.collisions, 6);
}

/// An elastic carrier: its impacts in a turn would not fit into memory.
TEST(SteadyMotion, OfVeryManyImpactsIsAveragedOverAPartOfATurn) {
  Scene scene;
  scene.wall_upper = 1e-7;
  scene.start_position = 0;
  scene.start_velocity = 1;
  scene.counting_limit = 1e-3;
  const SteadyMotion motion = steady_motion(scene);
  EXPECT_FALSE(motion.settled);
  EXPECT_NEAR(motion.collisions_per_turn() / (2 * std::numbers::pi * 1e7), 1, 1e-4);
  EXPECT_NEAR(motion.fastest_impact(), 1, 1e-12);
}

}  // namespace
}  // namespace ricochet::carrier_track
