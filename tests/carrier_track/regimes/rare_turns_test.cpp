#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "problems/carrier_track/regimes/sampled_turns.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

/// A motion that knows the even phases alone.
DisturbedMotion evenly_sampled(std::uint64_t seed, double omega) {
  DisturbedMotion motion = disturbed_motion(at_speed(random_disturbed_machine(seed), omega));
  motion.watched.clear();
  motion.known.clear();
  const auto [least, most] =
      std::ranges::minmax_element(motion.turns, {}, &DisturbedTurn::collisions);
  motion.least = least->collisions;
  motion.most = most->collisions;
  return motion;
}

/// Expects the fewest and most collisions that turns at many phases have, of which the even ones
/// alone lack some.
void expect_extremes_of_many_phases(std::uint64_t seed, double omega) {
  DisturbedMotion motion = evenly_sampled(seed, omega);
  const int sampled_least = motion.least;
  const int sampled_most = motion.most;
  int least = sampled_least;
  int most = sampled_most;
  constexpr int phases = 4000;
  for (int k = 0; k < phases; ++k) {
    const int count = turn_at(motion, 2 * std::numbers::pi * k / phases).collisions;
    least = std::min(least, count);
    most = std::max(most, count);
  }
  EXPECT_TRUE(least < sampled_least || most > sampled_most) << seed << " at " << omega;
  for (const DisturbedTurn& turn : rare_turns(motion)) {
    EXPECT_TRUE(turn.collisions < motion.least || turn.collisions > motion.most);
    EXPECT_EQ(turn.collisions, turn_at(motion, turn.phase).collisions);
    motion.least = std::min(motion.least, turn.collisions);
    motion.most = std::max(motion.most, turn.collisions);
  }
  EXPECT_EQ(motion.least, least) << seed << " at " << omega;
  EXPECT_EQ(motion.most, most) << seed << " at " << omega;
}

TEST(RareTurns, AreFoundWhereMarginsChangeMuchFromPhaseToPhase) {
  expect_extremes_of_many_phases(30, 0.870569255);
  expect_extremes_of_many_phases(42, 2.132245922);
}

/// Impacts appear and vanish within two even phases, between which the turns are alike.
TEST(RareTurns, AreFoundBesideMarginsThatChangeMuch) {
  expect_extremes_of_many_phases(18, 0.7404758458);
}

/// For some phases one impact is the first of a turn and the next one the last.
TEST(RareTurns, AreFoundWhereATurnBeginsAfterAnImpact) {
  expect_extremes_of_many_phases(51, 0.5759682684);
}

TEST(RareTurns, AreFoundWhereOnePhaseInSixThousandHasThem) {
  const DisturbedMotion motion = evenly_sampled(10, 1.43634);
  ASSERT_EQ(turn_at(motion, 4.227).collisions, 1);
  ASSERT_EQ(turn_at(motion, 4.226).collisions, 2);
  ASSERT_EQ(turn_at(motion, 4.228).collisions, 2);
  const auto rare = rare_turns(motion);
  EXPECT_TRUE(std::ranges::any_of(rare, [](const auto& turn) { return turn.collisions == 1; }));
}

TEST(RareTurns, AreNoneWhereAllPhasesCountTheSame) {
  const DisturbedMotion motion = evenly_sampled(19, 3);
  EXPECT_EQ(motion.least, motion.most);
  EXPECT_TRUE(rare_turns(motion).empty());
}

}  // namespace
}  // namespace ricochet::carrier_track
