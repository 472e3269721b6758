#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/regimes/long_simulation.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

Scene disturbed(double disturbance, double omega) {
  Scene machine = default_machine();
  machine.disturbance = disturbance;
  machine.omega = omega;
  return machine;
}

std::vector<double> even_phases(int count) {
  std::vector<double> phases;
  for (int k = 0; k < count; ++k) phases.push_back(2 * std::numbers::pi * k / count);
  return phases;
}

/// The fewest and the most collisions of the turns at many phases.
std::pair<int, int> extremes_of(const DisturbedMotion& motion, int phases) {
  const auto turns = turns_at_phases(motion.machine, even_phases(phases), motion.turns_before);
  const auto [least, most] = std::ranges::minmax_element(turns, {}, &DisturbedTurn::collisions);
  return {least->collisions, most->collisions};
}

TEST(DisturbedTurn, HasTheImpactsOfASimulationToTheLastRebound) {
  Scene machine = disturbed(0.3, 6);
  machine.restitution_lower = machine.restitution_upper = 0.9;
  machine = disturbed_motion(machine).machine;
  for (const int before : {0, 2}) {
    const auto phases = even_phases(10);
    const auto turns = turns_at_phases(machine, phases, before);
    ASSERT_EQ(turns.size(), phases.size());
    for (std::size_t k = 0; k < phases.size(); ++k) {
      EXPECT_EQ(turns[k].phase, phases[k]);
      const double earlier = 2 * std::numbers::pi * before * machine.disturbance_frequency / 6;
      const double start = phases[k] - earlier;
      const ObservedTurn observed = observed_turns(machine, {&start, 1}, before, 1)[0];
      EXPECT_EQ(turns[k].collisions, observed.collisions);
      EXPECT_NEAR(std::log(observed.fastest / machine.counting_limit), turns[k].margin(1), 1e-12);
      // Those too slow to count that a margin can be taken of are there, too.
      ASSERT_GT(turns[k].margins.size(), static_cast<std::size_t>(turns[k].collisions));
      EXPECT_EQ(turns[k].impacts.size(), turns[k].margins.size());
      EXPECT_GT(turns[k].margins.back(), lowest_margin);
      EXPECT_EQ(turns[k].margin(1000), lowest_margin);
    }
  }
}

TEST(DisturbedTurn, IsTheSameAloneAsBesideOthers) {
  const Scene machine = disturbed_motion(disturbed(1, 8.1)).machine;
  const std::vector<double> phases = {0.1, 1.2, 2.3};
  const auto together = turns_at_phases(machine, phases, 0);
  for (std::size_t k = 0; k < phases.size(); ++k) {
    EXPECT_EQ(together[k].margins, turns_at_phases(machine, {&phases[k], 1}, 0).front().margins);
  }
}

TEST(ObservedTurn, HasTheNumbersOfTheOrbitWhereNothingDisturbs) {
  Scene machine = default_machine();
  machine.omega = 7;
  const SteadyMotion motion = steady_motion(machine);
  const auto turns = observed_turns(motion.orbit, even_phases(2), 1, 3);
  ASSERT_EQ(turns.size(), 6U);
  for (const ObservedTurn& observed : turns) {
    EXPECT_EQ(observed.collisions, motion.collisions);
    EXPECT_NEAR(observed.energy / motion.energy, 1, 1e-9);
    EXPECT_NEAR(observed.share_at_rest, motion.share_at_rest, 1e-9);
    EXPECT_NEAR(observed.fastest / motion.fastest_impact(), 1, 1e-9);
  }
}

TEST(DisturbedMotion, CountsAsManyAsALongSimulation) {
  for (const double omega : {2.6123, 5.0123, 7.7123, 9.8123, 15.0123}) {
    const DisturbedMotion motion = disturbed_motion(disturbed(1.0, omega));
    ASSERT_TRUE(motion.settled) << omega;
    EXPECT_EQ(motion.least, motion.most);
    EXPECT_EQ(collisions_in_the_long_run(motion.machine, omega, 700, 600), motion.most);
    EXPECT_EQ(long_run_of(motion).collisions_per_turn, motion.most);
  }
}

TEST(DisturbedMotion, KnowsTheLeastAndTheMostOfAllPhases) {
  // Between 8.06 and 8.09 rad/s the phase decides which rebounds count.
  const DisturbedMotion motion = disturbed_motion(disturbed(1.0, 8.0779));
  ASSERT_TRUE(motion.settled);
  EXPECT_EQ(std::pair(motion.least, motion.most), extremes_of(motion, 2000));
  EXPECT_LT(motion.least, motion.most);
  EXPECT_EQ(extreme_turn(motion, motion.most, Extreme::most).collisions, motion.most);
  EXPECT_EQ(extreme_turn(motion, motion.least + 1, Extreme::least).collisions, motion.least);
}

TEST(DisturbedMotion, KnowsTurnsThatFewPhasesHave) {
  struct Rare {
    std::uint64_t seed;
    double omega;
  };
  // Where margins change much from phase to phase, where impacts appear and vanish between two even
  // phases, where an impact passes from one turn to the next, where slow impacts nearly graze.
  int unseen = 0;  // by even phases
  for (const auto& [seed, omega] :
       {Rare{30, 0.870569255}, Rare{42, 2.132245922}, Rare{18, 0.7404758458},
        Rare{51, 0.5759682684}, Rare{27, 7.9598}, Rare{50, 5.2931}, Rare{18, 0.98},
        Rare{27, 8.63544}}) {
    const DisturbedMotion motion =
        disturbed_motion(at_speed(random_disturbed_machine(seed), omega));
    ASSERT_TRUE(motion.settled);
    EXPECT_EQ(std::pair(motion.least, motion.most), extremes_of(motion, 4000)) << seed;
    unseen += std::pair(motion.least, motion.most) != extremes_of(motion, 16);
  }
  EXPECT_GT(unseen, 3);
}

TEST(DisturbedMotion, LooksAtOtherPhasesToo) {
  // One phase in six thousand has one collision.
  const double rare = 4.227;
  const Scene machine = at_speed(random_disturbed_machine(10), 1.43634);
  const DisturbedMotion motion = disturbed_motion(machine, {&rare, 1});
  EXPECT_EQ(motion.least, 1);
  EXPECT_EQ(extremes_of(motion, 1000).first, 2);
}

TEST(DisturbedMotion, HasTheSameTurnsAfterMoreTurns) {
  const DisturbedMotion motion = disturbed_motion(disturbed(1.0, 7.7));
  const double phase = 1.0;
  const auto here = turns_at_phases(motion.machine, {&phase, 1}, motion.turns_before);
  const auto later = turns_at_phases(motion.machine, {&phase, 1}, motion.turns_before + 2);
  ASSERT_GT(here[0].collisions, 0);
  EXPECT_NEAR(here[0].margin(1), later[0].margin(1), 1e-9);
}

TEST(DisturbedMotion, RemembersWhereFrictionHeldTheCarrier) {
  // Most turns have no collision, so that those of two starts are alike though the carrier stands
  // at other places in the gap.
  const DisturbedMotion motion = disturbed_motion(disturbed(0.1, 1.3865));
  EXPECT_GT(collisions_in_the_long_run(motion.machine, 1.3865, 6000, 5000), 0);
  EXPECT_TRUE(!motion.settled || motion.most > 0);
}

TEST(DisturbedMotion, RemembersHowHighItIsWithoutAnUpperWall) {
  // It comes back to the wall once in a hundred turns: no turn depends on its phase alone. Just
  // beyond its release few phases lift it.
  for (const double omega : {2.573, 3.0}) {
    EXPECT_FALSE(disturbed_motion(at_speed(strange_machine(102), omega)).settled) << omega;
  }
}

TEST(DisturbedMotion, ForgetsItsStartAtEveryPhase) {
  // After two turns one phase in fifty still tells two starts apart.
  const Scene machine = scene_of(find_case("C9"), default_machine());
  const DisturbedMotion motion = disturbed_motion(at_speed(machine, 0.7302));
  const auto turns =
      observed_turns(motion.machine, {&motion.machine.disturbance_phase, 1}, 60, 1000);
  const auto [least, most] = std::ranges::minmax_element(turns, {}, &ObservedTurn::collisions);
  EXPECT_EQ(motion.least, least->collisions);
  EXPECT_EQ(motion.most, most->collisions);
}

TEST(DisturbedMotion, IsStillWhileAllForcesTogetherAreHeld) {
  const double held = 0.1 * 11.772 + 0.01;  // friction and pull of the machine [N]
  const double radius =
      default_machine().centrifugal_mass_radius - default_machine().slider_mass_radius;
  const double release = std::sqrt((held - 0.5) / radius);
  EXPECT_FALSE(disturbed_motion(disturbed(0.5, release * (1 - 1e-9))).moves);
  EXPECT_TRUE(disturbed_motion(disturbed(0.5, release * (1 + 1e-9))).moves);
}

/// Of machines whose regimes are known: what is simulated is within them, and nearly all of it is
/// reached.
TEST(SampledTurns, AreThoseOfTheRegimes) {
  for (const char* name : {"C1", "C3", "C5", "C9"}) {
    const Scene scene = scene_of(find_case(name), default_machine());
    const auto regimes = regimes_of(scene, {2, 6});
    int compared = 0;
    const auto sampled = sampled_turns(scene, 2, 6);
    ASSERT_EQ(sampled.size(), 24U);
    EXPECT_EQ(sampled.front().omega, 2);
    EXPECT_EQ(sampled.back().omega, 6);
    for (const SampledTurns& turns : sampled) {
      const Regime& regime = regime_at(regimes, turns.omega);
      if (!regime.certain) continue;
      ++compared;
      EXPECT_LE(turns.most_per_turn, regime.most_per_turn) << name << ", " << turns.omega;
      EXPECT_NEAR(turns.most_per_turn, regime.most_per_turn, 1) << name << ", " << turns.omega;
    }
    EXPECT_GT(compared, 12) << name;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
