#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/regimes/long_simulation.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

/// How many random machines: more in a longer study.
int machines() {
  const char* asked = std::getenv("RICOCHET_REGIME_MACHINES");
  return asked == nullptr ? 10 : std::atoi(asked);
}

TEST(Regimes, OfTheDefaultMachineAreALadder) {
  const auto regimes = regimes_of(default_machine());
  const std::vector<double> collisions = {0, 0, 1, 2, 3, 4};
  ASSERT_EQ(regimes.size(), collisions.size());
  for (std::size_t i = 0; i < regimes.size(); ++i) {
    EXPECT_EQ(regimes[i].collisions_per_turn, collisions[i]);
    EXPECT_TRUE(regimes[i].certain);
    if (i > 0) {
      EXPECT_EQ(regimes[i].from, regimes[i - 1].to);
    }
  }
  EXPECT_FALSE(regimes[0].moves);
  EXPECT_EQ(regimes[0].ends_by, RegimeEnd::release);
  EXPECT_EQ(regimes[3].ends_by, RegimeEnd::counting_limit);
  EXPECT_NEAR(regimes[3].to, 8.08, 0.005);
  EXPECT_EQ(regimes.back().to, 18);
  EXPECT_EQ(regimes.back().ends_by, RegimeEnd::range);
}

/// Machines that are their own mirror image, turned by half a turn: impacts come in pairs of one
/// speed, one on each wall.
std::vector<Scene> mirror_images() {
  Scene first;
  first.mass = 1.2;
  first.wall_upper = 0.8e-3;
  first.restitution_lower = first.restitution_upper = 0.5;
  first.friction = 0.2;
  first.normal_force = 11.8;
  first.centrifugal_mass_radius = 1.2 * 0.065;
  first.counting_limit = 5e-3;
  first.start_position = 0;
  std::vector<Scene> all(7, first);
  all[1].start_position = 0.4e-3;
  all[2].restitution_lower = all[2].restitution_upper = 0.9;
  all[3].friction = 0.05;
  all[4].slider_mass_radius = 1e-3;
  all[5].pull = 1;
  all[5].pull_rotates = true;
  all[6].restitution_lower = all[6].restitution_upper = 0.72;
  all[6].wall_upper = 3.9e-3;
  all[6].counting_limit = 1.35e-4;
  return all;
}

TEST(Regimes, OfAMirrorImageHaveBordersOfPairs) {
  for (const Scene& machine : mirror_images()) {
    const auto regimes = regimes_of(machine);
    ASSERT_GT(regimes.size(), 4U);
    for (std::size_t i = 0; i < regimes.size(); ++i) {
      const Regime& regime = regimes[i];
      EXPECT_GT(regime.to / regime.from - 1, border_resolution);
      ASSERT_TRUE(regime.certain);
      EXPECT_EQ(std::fmod(regime.collisions_per_turn, 2), 0) << "from " << regime.from;
      // Beside both borders, by simulations.
      for (const double omega : {regime.from * (1 + 1e-9), regime.to * (1 - 1e-9)}) {
        EXPECT_EQ(collisions_in_the_long_run(
                      omega < regime.last.orbit.omega ? regime.first.orbit : regime.last.orbit,
                      omega, 300, whole_periods(regime)),
                  regime.collisions_per_turn)
            << omega;
      }
    }
  }
}

/// Where a carrier is just released it hardly leaves its wall, and no impact counts yet.
Scene released_softly() {
  Scene machine;
  machine.mass = 0.012;
  machine.wall_upper = machine.start_position = 0.035;
  machine.restitution_lower = 0.9;
  machine.restitution_upper = 0;
  machine.friction = 0.75;
  machine.normal_force = 8;
  machine.pull = -0.01;
  machine.centrifugal_mass_radius = 0.14;
  machine.counting_limit = 3e-4;
  return machine;
}

/// The second regime is silent, though the carrier moves, and no wider than this share of its
/// speed.
void expect_silence_after_release(const std::vector<Regime>& regimes, double widest) {
  const Regime& next = regimes[1];
  EXPECT_EQ(regimes[0].ends_by, RegimeEnd::release);
  EXPECT_TRUE(next.moves);
  EXPECT_EQ(next.most_per_turn, 0);
  EXPECT_LT(next.to / next.from - 1, widest);
}

TEST(Regimes, NextToTheReleaseAreSilent) {
  const Scene machine = released_softly();
  const auto regimes = regimes_of(machine, {6, 6.6});
  ASSERT_EQ(regimes.size(), 3U);
  expect_silence_after_release(regimes, 1e-4);
  const Regime& next = regimes[1];
  EXPECT_EQ(next.ends_by, RegimeEnd::counting_limit);
  for (const double omega : {next.from * (1 + 1e-7), next.to * (1 - 1e-7)}) {
    EXPECT_EQ(collisions_in_the_long_run(machine, omega, 100, 20), 0);
  }
  EXPECT_EQ(collisions_in_the_long_run(machine, next.to * (1 + 1e-7), 100, 20), 1);
}

TEST(Regimes, NextToTheReleaseUnderADisturbanceAreSilent) {
  Scene machine = released_softly();
  machine.disturbance = 1e-3;
  machine.disturbance_frequency = 0.7;
  const auto regimes = regimes_of(machine, {6, 6.6});
  ASSERT_GT(regimes.size(), 2U);
  expect_silence_after_release(regimes, 1e-3);
  EXPECT_TRUE(regimes[1].certain);
  EXPECT_GT(regimes[2].most_per_turn, 0);
}

TEST(Regimes, ThatBeginOrEndAtABorderHaveNoOtherBeforeOrBeyond) {
  const Scene machine = mirror_images()[0];
  const auto whole = regimes_of(machine);
  const double border = whole[2].to;
  for (const double end : {border, border * (1 + 1e-14), border * (1 - 1e-14)}) {
    for (const Regime& regime : regimes_of(machine, {end, 18})) {
      EXPECT_GT(regime.to / regime.from - 1, border_resolution);
    }
    const auto until = regimes_of(machine, {0.01, end});
    EXPECT_EQ(until.back().to, end);
    EXPECT_EQ(until.back().ends_by, RegimeEnd::range);
    for (const Regime& regime : until) {
      EXPECT_GT(regime.to / regime.from - 1, border_resolution);
    }
  }
}

TEST(Regimes, AreKnownUpToTheTimeLimit) {
  const Scene machine = mirror_images()[6];
  const RegimeOptions far{0.01, 1000};
  const auto whole = regimes_of(machine, far);
  ASSERT_NE(whole.back().ends_by, RegimeEnd::time_limit);
  std::vector<Regime> cut;
  {
    const TimeLimit limit(0.02);
    cut = regimes_of(machine, far);
  }
  const Regime& last = cut.back();
  EXPECT_EQ(last.ends_by, RegimeEnd::time_limit);
  EXPECT_FALSE(last.certain);
  EXPECT_LT(last.to, far.to);
  EXPECT_GE(last.to, last.from);
  for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
    EXPECT_EQ(cut[i].to, whole[i].to);
    EXPECT_EQ(cut[i].ends_by, whole[i].ends_by);
    EXPECT_EQ(cut[i].last.energy_per_turn, whole[i].last.energy_per_turn);
  }
  const TimeLimit enough(1e3);
  const auto same = regimes_of(machine, far);
  ASSERT_EQ(same.size(), whole.size());
  for (std::size_t i = 0; i < same.size(); ++i) EXPECT_EQ(same[i].to, whole[i].to);
}

TEST(Regimes, UnderADisturbanceAboveFrictionEndAtTheTimeLimit) {
  for (const auto& [force, frequency] :
       {std::pair(3.0, 7.3), {5.0, 31.0}, {2.5, 1.7}, {3.0, 113.0}, {10.0, 7.3}}) {
    Scene machine = mirror_images()[0];
    machine.disturbance = force;
    machine.disturbance_frequency = frequency;
    const auto start = std::chrono::steady_clock::now();
    const TimeLimit limit(0.3);
    try {
      const auto regimes = regimes_of(machine);
      EXPECT_EQ(regimes.back().ends_by, RegimeEnd::time_limit);
      for (const Regime& regime : regimes) EXPECT_FALSE(regime.certain);
    } catch (const TimeLimitReached&) {
      // Not even the motion at the slowest speed is known.
    }
    EXPECT_THROW(quiet_up_to(machine, 1e9), TimeLimitReached);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

/// Compares both sides of every border of a machine with long simulations; returns how many.
int compare_borders(int seed) {
  const Scene machine = random_machine(static_cast<std::uint64_t>(seed));
  const auto regimes = regimes_of(machine, {0.3, 18});
  for (std::size_t i = 0; i + 1 < regimes.size(); ++i) {
    const Regime& slow = regimes[i];
    const Regime& fast = regimes[i + 1];
    if (slow.certain && slow.to - slow.from > 2 * beside(slow) * slow.to) {
      EXPECT_DOUBLE_EQ(slow.collisions_per_turn,
                       collisions_in_the_long_run(slow.last.orbit, slow.to * (1 - beside(slow)),
                                                  300, whole_periods(slow)))
          << "machine " << seed << " below " << slow.to << ", " << name_of(slow.ends_by);
    }
    if (fast.certain && fast.to - fast.from > 2 * beside(slow) * fast.to) {
      EXPECT_DOUBLE_EQ(fast.collisions_per_turn,
                       collisions_in_the_long_run(fast.first.orbit, slow.to * (1 + beside(slow)),
                                                  300, whole_periods(fast)))
          << "machine " << seed << " above " << slow.to << ", " << name_of(slow.ends_by);
    }
  }
  return static_cast<int>(regimes.size()) - 1;
}

TEST(Regimes, HaveBordersThatLongSimulationsBracket) {
  int borders = 0;
  for (int seed = 1; seed <= machines(); ++seed) borders += compare_borders(seed);
  EXPECT_GT(borders, 5 * machines());
}

TEST(Regimes, HaveBordersWhereASearchMeetsOne) {
  compare_borders(30);  // its margin is exactly 0 at 1.2267 rad/s
}

TEST(Regimes, AreNotCertainAmongIrregularMotions) {
  for (const int seed : {148, 151}) compare_borders(seed);
}

TEST(Regimes, EndWhereAnUnstableOrbitIsFollowed) {
  const auto regimes = regimes_of(random_machine(134), {8, 12});
  EXPECT_EQ(regimes.back().to, 12);
}

TEST(Regimes, MissNoPairOfBordersWithinAStep) {
  // One rebound counts from 4.018 to 4.026 rad/s: then the carrier touches a wall once more.
  const auto rebound = regimes_of(random_machine(787), {3.9, 4.1});
  EXPECT_EQ(regime_at(rebound, 4.0120).collisions_per_turn, 8);
  EXPECT_EQ(regime_at(rebound, 4.0195).collisions_per_turn, 9);
  EXPECT_EQ(regime_at(rebound, 4.0300).collisions_per_turn, 8);
  // One impact ceases to count just before another begins to.
  const auto exchange = regimes_of(random_machine(4), {2.6, 2.8});
  EXPECT_EQ(regime_at(exchange, 2.6937).collisions_per_turn, 5);
  EXPECT_EQ(regime_at(exchange, 2.6941).collisions_per_turn, 4);
  EXPECT_EQ(regime_at(exchange, 2.7000).collisions_per_turn, 5);
  // A second impact counts for a little: a touch makes both slower, the second one first.
  const auto touch = regimes_of(random_machine(1277), {5.5, 5.7});
  EXPECT_EQ(regime_at(touch, 5.63275).collisions_per_turn, 1);
  EXPECT_EQ(regime_at(touch, 5.63304).collisions_per_turn, 2);
  EXPECT_EQ(regime_at(touch, 5.63305).collisions_per_turn, 1);
  EXPECT_EQ(regime_at(touch, 5.63310).collisions_per_turn, 0);
  // The speed of one impact falls 0.02 % below the counting limit and rises again.
  const auto dip = regimes_of(random_machine(4267), {1.509, 1.525});
  EXPECT_EQ(regime_at(dip, 1.5160).collisions_per_turn, 2);
  EXPECT_EQ(regime_at(dip, 1.5166).collisions_per_turn, 1);
  EXPECT_EQ(regime_at(dip, 1.5180).collisions_per_turn, 2);
  const auto shallow = regimes_of(random_machine(522), {1.5, 1.618});
  EXPECT_EQ(regime_at(shallow, 1.6080).collisions_per_turn, 6);
  EXPECT_EQ(regime_at(shallow, 1.6100).collisions_per_turn, 5);
  EXPECT_EQ(regime_at(shallow, 1.6120).collisions_per_turn, 6);
  // An impact appears at 7.74 rad/s and vanishes at 8.31.
  const auto visit = regimes_of(random_machine(798), {6.4, 8.5});
  EXPECT_EQ(regime_at(visit, 7.7).collisions_per_turn, 3);
  EXPECT_EQ(regime_at(visit, 8.0).collisions_per_turn, 4);
  EXPECT_EQ(regime_at(visit, 8.4).collisions_per_turn, 3);
}

/// From 1.602 rad/s on, the walk goes on from a border at which the margin is exactly 0.
TEST(Regimes, EndAtTheSecondZeroOfAMarginThatIsZeroAtTheFirst) {
  const auto regimes = regimes_of(random_machine(522), {1.602, 1.6158});
  ASSERT_EQ(regimes.size(), 3U);
  EXPECT_EQ(regimes[1].collisions_per_turn, 5);
  EXPECT_NEAR(regimes[1].to, 1.610743, 1e-6);
}

/// At 14.5 rad/s two motions are possible. A long step meets the one of 10 collisions.
TEST(Regimes, KeepTheMotionThatTheyHave) {
  const auto regimes = regimes_of(random_machine(125), {0.3, 14.6});
  EXPECT_EQ(regime_at(regimes, 14.52).collisions_per_turn, 9);
}

/// Collisions and energy of the late turns.
struct LateTurns : Observer {
  const Scene* scene = nullptr;
  double from = 0;
  int collisions = 0;
  double energy = 0;

  void impact(double time, Wall wall, double speed) {
    if (time < from || speed <= 0) return;
    if (is_counted(speed, scene->counting_limit)) ++collisions;
    energy += impact_loss(*scene, wall) * speed * speed;
  }
};

TEST(Regimes, HaveTheCollisionsAndTheEnergyOfLongSimulationsAtRandomSpeeds) {
  constexpr int before = 150;
  int compared = 0;
  for (int seed = 1; seed <= machines(); ++seed) {
    const Scene machine = random_machine(static_cast<std::uint64_t>(seed));
    MachineDraw draw(static_cast<std::uint64_t>(seed) + 7'000'000);
    for (const Regime& regime : regimes_of(machine, {0.3, 18})) {
      if (!regime.certain || regime.to - regime.from < 4e-6 * regime.to) continue;
      const double drawn = draw.even(regime.from, regime.to);
      const double omega = std::clamp(drawn, regime.from * (1 + 1e-6), regime.to * (1 - 1e-6));
      const bool early = omega - regime.from < regime.to - omega;
      Scene scene = brought(early ? regime.first.orbit : regime.last.orbit, omega);
      const SteadyMotion motion = steady_motion(scene);
      const int observed = whole_periods(regime);
      scene.window = Revolutions{static_cast<double>(before + observed)};
      LateTurns late;
      late.scene = &scene;
      late.from = duration_of(scene) * before / (before + observed);
      ImpactModel<double>(scene).run(late);
      EXPECT_DOUBLE_EQ(regime.collisions_per_turn, static_cast<double>(late.collisions) / observed)
          << "machine " << seed << " at " << omega;
      EXPECT_NEAR(motion.energy_per_turn() / (late.energy / observed + 1e-15), 1,
                  late.energy > 0 ? 1e-6 : 1)
          << "machine " << seed << " at " << omega;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5 * machines());
}

TEST(Regimes, MissNoneThatAnEvenScanFinds) {
  int compared = 0;
  for (int seed = 1; seed <= std::max(1, machines() / 5); ++seed) {
    const Scene machine = random_machine(static_cast<std::uint64_t>(seed));
    const auto regimes = regimes_of(machine, {0.3, 18});
    Ramp ramp(machine);
    std::size_t i = 0;
    for (double omega = 0.3; omega < 18; omega *= 1.001) {
      const double counted = ramp.collisions_per_turn(omega);
      while (omega > regimes[i].to) ++i;
      // The ramp is late by a step.
      const bool at_a_border = omega < regimes[i].from * 1.002 || omega > regimes[i].to * 0.999;
      if (!regimes[i].certain || at_a_border) continue;
      EXPECT_NEAR(regimes[i].collisions_per_turn, counted, 0.026)
          << "machine " << seed << " at " << omega;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(Regimes, OfADisturbedMachineHaveBlurredBorders) {
  Scene machine = default_machine();
  machine.disturbance = 1;
  const auto regimes = regimes_of(machine, {7.5, 8.5});
  ASSERT_GE(regimes.size(), 3U);
  EXPECT_EQ(regimes.front().most_per_turn, 2);
  EXPECT_EQ(regimes.back().least_per_turn, 4);
  for (std::size_t i = 1; i + 1 < regimes.size(); ++i) {
    EXPECT_LT(regimes[i].least_per_turn, regimes[i].most_per_turn);
  }
  // At 1 N in 0.58 kg m 8.08^2 rad^2/s^2 = 38 N the border is blurred by some 0.3 %.
  EXPECT_NEAR(regimes.front().to, 8.065, 0.002);
  EXPECT_NEAR(regimes.back().from, 8.094, 0.002);
}

TEST(Regimes, OfADisturbedMachineHaveAllTheirBorders) {
  const auto regimes = regimes_of(random_disturbed_machine(19), {2.3, 5});
  EXPECT_EQ(regime_at(regimes, 3).least_per_turn, 2);
  EXPECT_EQ(regime_at(regimes, 3).most_per_turn, 2);
  EXPECT_EQ(regime_at(regimes, 4).least_per_turn, 3);
  EXPECT_EQ(regime_at(regimes, 4).most_per_turn, 3);
}

/// Strips of phases less than 0.02 rad wide open and close between even phases.
TEST(Regimes, OfADisturbedMachineCountStripsBetweenEvenPhases) {
  const auto regimes = regimes_of(random_disturbed_machine(30), {0.84, 0.88});
  for (const auto& [omega, most] : {std::pair{0.850280398, 3.0}, std::pair{0.870569255, 4.0}}) {
    EXPECT_EQ(regime_at(regimes, omega).most_per_turn, most) << omega;
    EXPECT_TRUE(regime_at(regimes, omega).certain) << omega;
  }
}

/// At 1.4363 rad/s the strip of turns that an impact has left before the next one comes in
/// vanishes, and opens again.
TEST(Regimes, OfADisturbedMachineBeginAgainAfterABorder) {
  const auto regimes = regimes_of(random_disturbed_machine(10), {1.4, 1.46});
  for (const double omega : {1.43, 1.4377538}) {
    EXPECT_EQ(regime_at(regimes, omega).least_per_turn, 1) << omega;
    EXPECT_EQ(regime_at(regimes, omega).most_per_turn, 3) << omega;
  }
}

/// Up to 0.9926745 rad/s the carrier strikes just after a turn begins, at ever fewer phases.
TEST(Regimes, OfADisturbedMachineEndWhereverTheirRangeBegins) {
  for (const auto& [from, to] : {std::pair{0.98, 1.0}, std::pair{0.9, 1.1}}) {
    const auto regimes = regimes_of(random_disturbed_machine(18), {from, to});
    ASSERT_EQ(regimes.size(), 2U) << from;
    EXPECT_NEAR(regimes[0].to, 0.9926745, 1e-6);
    EXPECT_EQ(std::pair(regimes[0].most_per_turn, regimes[1].most_per_turn), std::pair(3.0, 2.0));
  }
}

/// From 7.206 rad/s on some turns have an 18th collision, which vanishes by grazing at 7.234.
TEST(Regimes, OfADisturbedMachineFindAMarginThatPassesZeroAndJumps) {
  const auto regimes = regimes_of(random_disturbed_machine(23), {7.15, 7.3});
  EXPECT_EQ(regime_at(regimes, 7.20).most_per_turn, 17);
  EXPECT_EQ(regime_at(regimes, 7.22).most_per_turn, 18);
  EXPECT_EQ(regime_at(regimes, 7.25).most_per_turn, 17);
}

/// An almost elastic machine with three tenths of its friction: next to where its period doubles,
/// motions that settle in time and motions that do not follow each other at steps of rounding.
TEST(Regimes, EndWhereKindAndCountChangeInTurn) {
  Scene machine = strange_machine(10);
  machine.friction *= 0.3;
  const auto regimes = regimes_of(machine, {4, 4.4});
  EXPECT_EQ(regimes.back().to, 4.4);
  for (const auto& [omega, per_turn] :
       {std::pair{4.1, 0.0}, std::pair{4.225, 0.5}, std::pair{4.25, 1.0}}) {
    const Regime& here = regime_at(regimes, omega);
    EXPECT_EQ(here.collisions_per_turn, per_turn) << omega;
    const Scene there = brought(here.first.orbit, omega);
    EXPECT_EQ(collisions_in_the_long_run(there, omega, 3000, 400), per_turn) << omega;
  }
}

TEST(Regimes, RefuseWhatTheyCannotTell) {
  const Scene machine = default_machine();
  EXPECT_THROW(regimes_of(machine, {0, 18}), InputError);
  EXPECT_THROW(regimes_of(machine, {5, 5}), InputError);
  EXPECT_THROW(regimes_of(machine, {5, 1e6}), InputError);
  Scene peaks = machine;
  peaks.rule = CountRule::peaks;
  EXPECT_THROW(regimes_of(peaks), InputError);
  Scene soft = machine;
  soft.fidelity = Fidelity::compliant;
  EXPECT_THROW(regimes_of(soft), InputError);
  Scene profile = machine;
  profile.profile = {{0, 1}, {1, 2}};
  EXPECT_THROW(regimes_of(profile), InputError);
}

TEST(Regimes, CountWhatFewPhasesOfADisturbanceHave) {
  // Some turns of these machines are those of a few thousandths of all phases, which drift with the
  // speed.
  int narrow = 0;
  for (const auto& [seed, from, to] :
       {std::tuple{2, 0.35, 0.42}, std::tuple{12, 0.53, 0.75}, std::tuple{54, 5.0, 6.0}}) {
    const Scene machine = random_disturbed_machine(static_cast<std::uint64_t>(seed));
    for (const Regime& regime : regimes_of(machine, {from, to})) {
      if (!regime.certain || regime.turns == 0 || !regime.moves) continue;
      const double middle = 0.5 * (regime.from + regime.to);
      const DisturbedMotion motion = disturbed_motion(at_speed(machine, middle));
      if (!motion.settled) continue;
      int least = 1000;
      int most = 0;
      std::vector<double> phases;
      for (int k = 0; k < 4000; ++k) phases.push_back(2 * std::numbers::pi * k / 4000);
      for (const auto& turn : turns_at_phases(motion.machine, phases, motion.turns_before)) {
        least = std::min(least, turn.collisions);
        most = std::max(most, turn.collisions);
      }
      EXPECT_EQ(regime.least_per_turn, least) << seed << " at " << middle;
      EXPECT_EQ(regime.most_per_turn, most) << seed << " at " << middle;
      narrow += least != most;
    }
  }
  EXPECT_GT(narrow, 5);
}

}  // namespace
}  // namespace ricochet::carrier_track
