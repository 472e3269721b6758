#include "problems/carrier_track/regimes/disturbed_motion.h"

#include "problems/carrier_track/regimes/phase_tip.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "tests/carrier_track/regimes/machines.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

Scene disturbed(double disturbance, double omega) {
  return with(default_machine(), set::disturbance(disturbance), set::omega(omega));
}

TEST(DisturbedTurn, HasTheImpactsOfASimulationToTheLastRebound) {
  const Scene machine = disturbed_motion(with(disturbed(0.3, 6), set::restitution(0.9))).machine;
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
  const SteadyMotion motion = steady_motion(at_speed(default_machine(), 7.0));
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
  // Where margins change much from phase to phase, where impacts appear and vanish between two even
  // phases, where an impact passes from one turn to the next, where slow impacts nearly graze.
  int unseen = 0;  // by even phases
  for (const auto& [seed, omega] : {std::pair{30, 0.870569255},
                                    {42, 2.132245922},
                                    {18, 0.7404758458},
                                    {51, 0.5759682684},
                                    {27, 7.9598},
                                    {50, 5.2931},
                                    {18, 0.98},
                                    {27, 8.63544}}) {
    const DisturbedMotion motion = disturbed_motion(
        at_speed(random_disturbed_machine(static_cast<std::uint64_t>(seed)), omega));
    ASSERT_TRUE(motion.settled);
    EXPECT_EQ(std::pair(motion.least, motion.most), extremes_of(motion, 4000)) << seed;
    unseen += std::pair(motion.least, motion.most) != extremes_of(motion, 16);
  }
  EXPECT_GT(unseen, 3);
}

TEST(DisturbedMotion, LooksAtOtherPhasesToo) {
  // One phase in six thousand has one collision.
  const double rare = 4.227;
  const DisturbedMotion motion =
      disturbed_motion(at_speed(random_disturbed_machine(10), 1.43634), {&rare, 1});
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

TEST(DisturbedMotion, RemembersWhereFrictionHeldTheCarrierAndHowHighItIs) {
  // Most turns have no collision, so that those of two starts are alike though the carrier stands
  // at other places in the gap.
  const DisturbedMotion motion = disturbed_motion(disturbed(0.1, 1.3865));
  EXPECT_GT(collisions_in_the_long_run(motion.machine, 1.3865, 6000, 5000), 0);
  EXPECT_TRUE(!motion.settled || motion.most > 0);
  // Without an upper wall it comes back once in a hundred turns: no turn depends on its phase
  // alone. Just beyond its release few phases lift it.
  for (const double omega : {2.573, 3.0}) {
    EXPECT_FALSE(disturbed_motion(at_speed(strange_machine(102), omega)).settled) << omega;
  }
}

TEST(DisturbedMotion, ForgetsItsStartAtEveryPhase) {
  // After two turns one phase in fifty still tells two starts apart.
  const DisturbedMotion motion = disturbed_motion(at_speed(case_scene("C9"), 0.7302));
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
    const Scene scene = case_scene(name);
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

DisturbedMotion motion_at(const std::string& id, double omega) {
  return disturbed_motion(at_speed(case_scene(id), omega));
}

/// Turns at 2,000 phases around that of a tip in which the impact counts so.
int beyond_near(const DisturbedMotion& motion, const PhaseTip& tip, double omega, int rank,
                Extreme extreme) {
  std::vector<SpeedAndPhase> places;
  for (int k = -1000; k <= 1000; ++k) places.push_back({omega, tip.phase + 2e-5 * k});
  int count = 0;
  for (const DisturbedTurn& turn : turns_of(motion, places)) {
    if (is_beyond(turn, rank, extreme)) ++count;
  }
  return count;
}

TEST(PhaseTip, IsTheLastSpeedAtWhichSomePhaseCountsSo) {
  // Margins that are smooth, and some beside a jump.
  for (const auto& [id, from, until, rank, extreme] :
       {std::tuple{"C5", 8.0785, 8.0770, 3, Extreme::most},
        {"C7", 2.8970, 2.8985, 1, Extreme::least},
        {"C5", 1.4950, 1.5100, 1, Extreme::least}}) {
    const DisturbedMotion motion = motion_at(id, from);
    ASSERT_TRUE(has_beyond(motion, rank, extreme)) << from;
    const PhaseTip tip = phase_tip(motion, motion_at(id, until), rank, extreme);
    ASSERT_TRUE(tip.is_reached) << from;
    const double outwards = until > from ? 1e-9 : -1e-9;
    EXPECT_EQ(beyond_near(motion, tip, tip.omega * (1 + 2 * outwards), rank, extreme), 0);
    EXPECT_GT(beyond_near(motion, tip, tip.omega * (1 - outwards), rank, extreme), 0);
  }
  const PhaseTip early =
      phase_tip(motion_at("C7", 2.8970), motion_at("C7", 2.8971), 1, Extreme::least);
  EXPECT_FALSE(early.is_reached) << "the search ends before it";
  EXPECT_EQ(early.omega, 2.8971);
}

TEST(PhaseTip, IsFollowedWhereFewPhasesCountSoAndDriftWithTheSpeed) {
  // From 0.36103 rad/s on, a few phases have one collision; at 0.3650 others than at 0.3611.
  const Scene machine = random_disturbed_machine(2);
  const DisturbedMotion motion = disturbed_motion(at_speed(machine, 0.3650));
  const DisturbedMotion other = disturbed_motion(at_speed(machine, 0.3600));
  const PhaseTip tip = phase_tip(motion, other, 2, Extreme::least);
  ASSERT_TRUE(tip.is_reached);
  EXPECT_NEAR(tip.omega, 0.36103, 1e-5);
  EXPECT_GT(beyond_near(motion, tip, tip.omega * (1 + 1e-7), 2, Extreme::least), 0);
  EXPECT_EQ(beyond_near(motion, tip, tip.omega * (1 - 1e-7), 2, Extreme::least), 0);
}

}  // namespace
}  // namespace ricochet::carrier_track
