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

TEST(ObservedTurn, HasTheNumbersOfTheOrbitWhereNothingDisturbs) {
  const SteadyMotion motion = steady_motion(at_speed(default_machine(), 7.0));
  const auto turns = observed_turns(motion.orbit, even_phases(2), 1, 3);
  ASSERT_EQ(turns.size(), 6U);
  const auto near = [](double expected) { return testing::DoubleNear(expected, 1e-9 * expected); };
  EXPECT_THAT(turns, Each(FieldsAre(motion.collisions, near(motion.fastest_impact()),
                                    near(motion.energy), near(motion.share_at_rest))));
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

TEST(DisturbedMotion, KnowsTurnsThatFewPhasesHave) {
  const auto random_at = [](std::uint64_t seed, double omega) {
    return at_speed(random_disturbed_machine(seed), omega);
  };
  int unseen = 0;  // by even phases
  // Where margins change much from phase to phase, where impacts appear and vanish between two even
  // phases, where an impact passes from one turn to the next, where slow impacts nearly graze.
  for (const Scene& scene :
       {random_at(30, 0.870569255), random_at(42, 2.132245922), random_at(18, 0.7404758458),
        random_at(51, 0.5759682684), random_at(27, 7.9598), random_at(50, 5.2931),
        random_at(18, 0.98), random_at(27, 8.63544),
        // Between 8.06 and 8.09 rad/s the phase decides which rebounds count.
        disturbed(1.0, 8.0779)}) {
    SCOPED_TRACE(scene.omega);
    const DisturbedMotion motion = disturbed_motion(scene);
    ASSERT_TRUE(motion.settled);
    EXPECT_EQ(std::pair(motion.least, motion.most), extremes_of(motion, 4000));
    EXPECT_LT(motion.least, motion.most);
    EXPECT_EQ(extreme_turn(motion, motion.most, Extreme::most).collisions, motion.most);
    EXPECT_EQ(extreme_turn(motion, motion.least + 1, Extreme::least).collisions, motion.least);
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
  const auto [least, most] = std::ranges::minmax(turns, {}, &ObservedTurn::collisions);
  EXPECT_EQ(std::pair(motion.least, motion.most), std::pair(least.collisions, most.collisions));
}

TEST(DisturbedMotion, IsStillWhileAllForcesTogetherAreHeld) {
  const Scene machine = default_machine();
  const double held = 0.1 * 11.772 + 0.01;  // friction and pull of the machine [N]
  const double radius = machine.centrifugal_mass_radius - machine.slider_mass_radius;
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
    EXPECT_EQ(std::pair(sampled.front().omega, sampled.back().omega), std::pair(2.0, 6.0));
    for (const auto& [omega, mean, most] : sampled) {
      const Regime& regime = regime_at(regimes, omega);
      if (!regime.certain) continue;
      ++compared;
      const double missed = regime.most_per_turn - most;
      EXPECT_TRUE(missed >= 0 && missed <= 1) << name << ", " << omega;
    }
    EXPECT_GT(compared, 12) << name;
  }
}

/// Whether in a turn at one of 2,000 phases around that of a tip the impact counts so.
bool is_beyond_near(const DisturbedMotion& motion, const PhaseTip& tip, double omega, int rank,
                    Extreme extreme) {
  std::vector<SpeedAndPhase> places;
  for (int k = -1000; k <= 1000; ++k) places.push_back({omega, tip.phase + 2e-5 * k});
  return std::ranges::any_of(turns_of(motion, places), [&](const DisturbedTurn& turn) {
    return is_beyond(turn, rank, extreme);
  });
}

TEST(PhaseTip, IsTheLastSpeedAtWhichSomePhaseCountsSo) {
  struct Row {
    Scene machine;
    double from, until, reach;
    int rank;
    Extreme extreme;
  };
  for (const auto& [machine, from, until, reach, rank, extreme] :
       {// Margins that are smooth, and some beside a jump.
        Row{case_scene("C5"), 8.0785, 8.0770, 1e-9, 3, Extreme::most},
        {case_scene("C7"), 2.8970, 2.8985, 1e-9, 1, Extreme::least},
        {case_scene("C5"), 1.4950, 1.5100, 1e-9, 1, Extreme::least},
        // From 0.36103 rad/s on, a few phases have one collision; at 0.3650 others than at 0.3611.
        {random_disturbed_machine(2), 0.3650, 0.3600, 1e-7, 2, Extreme::least}}) {
    SCOPED_TRACE(from);
    const DisturbedMotion motion = disturbed_motion(at_speed(machine, from));
    ASSERT_TRUE(has_beyond(motion, rank, extreme));
    const auto tip_until = [&, &machine = machine, &rank = rank, &extreme = extreme](double omega) {
      return phase_tip(motion, disturbed_motion(at_speed(machine, omega)), rank, extreme);
    };
    const PhaseTip tip = tip_until(until);
    ASSERT_TRUE(tip.is_reached);
    const double outwards = until > from ? reach : -reach;
    EXPECT_FALSE(is_beyond_near(motion, tip, tip.omega * (1 + 2 * outwards), rank, extreme));
    EXPECT_TRUE(is_beyond_near(motion, tip, tip.omega * (1 - outwards), rank, extreme));
    const PhaseTip early = tip_until(0.9 * from + 0.1 * tip.omega);
    EXPECT_FALSE(early.is_reached) << "the search ends before it";
    EXPECT_EQ(early.omega, 0.9 * from + 0.1 * tip.omega);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
