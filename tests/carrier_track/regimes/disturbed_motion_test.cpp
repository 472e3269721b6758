#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

Scene disturbed(double disturbance, double omega) {
  Scene machine = default_machine();
  machine.disturbance = disturbance;
  machine.omega = omega;
  return machine;
}

TEST(DisturbedMotion, CountsAsManyAsALongSimulation) {
  for (const double omega : {2.6123, 5.0123, 7.7123, 9.8123, 15.0123}) {
    const DisturbedMotion motion = disturbed_motion(disturbed(1.0, omega));
    ASSERT_TRUE(motion.settled) << omega;
    EXPECT_DOUBLE_EQ(collisions_in_the_long_run(motion.machine, omega, 700, 600),
                     collisions_per_turn(motion));
    EXPECT_EQ(motion.least, motion.most);
  }
}

TEST(DisturbedMotion, KnowsTheLeastAndTheMostOfAllPhases) {
  // Between 8.06 and 8.09 rad/s the phase decides which rebounds count.
  const Scene machine = disturbed(1.0, 8.0779);
  const DisturbedMotion motion = disturbed_motion(machine);
  ASSERT_TRUE(motion.settled);
  int least = 100;
  int most = 0;
  for (int k = 0; k < 2000; ++k) {
    const DisturbedTurn turn = turn_at(motion, 2 * std::numbers::pi * k / 2000);
    least = std::min(least, turn.collisions);
    most = std::max(most, turn.collisions);
  }
  EXPECT_EQ(motion.least, least);
  EXPECT_EQ(motion.most, most);
  EXPECT_LT(least, most);
}

TEST(DisturbedMotion, KnowsTheExtremesWhereImpactsAppearWithinAFewPhases) {
  // Counted at 40,000 phases.
  EXPECT_EQ(disturbed_motion(at_speed(random_disturbed_machine(27), 7.9598)).most, 13);
  EXPECT_EQ(disturbed_motion(at_speed(random_disturbed_machine(50), 5.2931)).least, 2);
}

TEST(DisturbedMotion, IsTheSameFollowedFromAnotherSpeed) {
  for (const double omega : {1.6, 3.0, 7.7, 8.0779}) {
    const DisturbedMotion here = disturbed_motion(disturbed(1.0, omega));
    const DisturbedMotion there = followed(disturbed_motion(disturbed(1.0, omega * 0.99)), omega);
    EXPECT_EQ(there.settled, here.settled) << omega;
    EXPECT_EQ(there.least, here.least) << omega;
    EXPECT_EQ(there.most, here.most) << omega;
    EXPECT_EQ(there.turns_before, here.turns_before) << omega;
    EXPECT_EQ(there.machine.start_position, here.machine.start_position) << omega;
  }
}

TEST(DisturbedMotion, LooksAtOtherPhasesAtTheNextSpeed) {
  const DisturbedMotion here = disturbed_motion(disturbed(1.0, 7.7));
  const DisturbedMotion there = followed(here, 7.71);
  ASSERT_EQ(here.turns.size(), there.turns.size());
  const double step = 2 * std::numbers::pi / static_cast<double>(here.turns.size());
  const double shift = std::abs(there.turns.front().phase - here.turns.front().phase);
  EXPECT_GT(shift, 0.2 * step);
  EXPECT_LT(shift, 0.8 * step);
}

TEST(DisturbedMotion, KnowsTheSameTurnByItsPhaseFromAnotherStart) {
  const DisturbedMotion motion = disturbed_motion(disturbed(1.0, 7.7));
  DisturbedMotion earlier = motion;
  earlier.turns_before = motion.turns_before + 2;
  const DisturbedTurn here = turn_at(motion, 1.0);
  const DisturbedTurn there = turn_at(earlier, phase_in(earlier, motion, 1.0));
  ASSERT_EQ(here.collisions, there.collisions);
  ASSERT_GT(here.collisions, 0);
  EXPECT_NEAR(here.speeds[0] / there.speeds[0], 1, 1e-9);
}

TEST(DisturbedMotion, WatchesAPhaseWhileNoEvenOneTellsOfIt) {
  // Up to 2.89778 rad/s some phases near 2.32 rad have a turn without collisions.
  const auto& cases = all_cases();
  const auto found =
      std::find_if(cases.begin(), cases.end(), [](const auto& one) { return one.id == "C7"; });
  DisturbedMotion motion = disturbed_motion(at_speed(scene_of(*found, default_machine()), 2.8973));
  motion.least = 1;
  motion.watched.clear();
  watch(motion, 2.317);
  EXPECT_EQ(motion.least, 0);
  EXPECT_EQ(followed(motion, 2.8975).least, 0);
  EXPECT_EQ(followed(motion, 2.8985).least, 1);
  EXPECT_TRUE(followed(motion, 2.8985).watched.empty());
}

TEST(DisturbedMotion, RemembersWhereFrictionHeldTheCarrier) {
  // Most turns have no collision, so that those of two starts are alike though the carrier stands
  // at other places in the gap.
  Scene machine = disturbed(0.1, 1.3865);
  const DisturbedMotion motion = disturbed_motion(machine);
  EXPECT_GT(collisions_in_the_long_run(motion.machine, 1.3865, 6000, 5000), 0);
  EXPECT_TRUE(!motion.settled || motion.most > 0);
}

TEST(DisturbedMotion, ForgetsItsStartAtEveryPhase) {
  // After two turns one phase in fifty still tells two starts apart.
  Scene machine = scene_of(find_case("C9"), default_machine());
  const DisturbedMotion motion = disturbed_motion(at_speed(machine, 0.7302));
  const auto turns =
      observed_turns(motion.machine, {&motion.machine.disturbance_phase, 1}, 60, 1000);
  const auto [least, most] = std::ranges::minmax_element(
      turns, {}, [](const ObservedTurn& observed) { return observed.turn.collisions; });
  EXPECT_EQ(motion.least, least->turn.collisions);
  EXPECT_EQ(motion.most, most->turn.collisions);
}

TEST(DisturbedMotion, IsStillWhileAllForcesTogetherAreHeld) {
  const double held = 0.1 * 11.772 + 0.01;  // friction and pull of the machine [N]
  const double radius =
      default_machine().centrifugal_mass_radius - default_machine().slider_mass_radius;
  const double release = std::sqrt((held - 0.5) / radius);
  EXPECT_FALSE(disturbed_motion(disturbed(0.5, release * (1 - 1e-9))).moves);
  EXPECT_TRUE(disturbed_motion(disturbed(0.5, release * (1 + 1e-9))).moves);
}

}  // namespace
}  // namespace ricochet::carrier_track
