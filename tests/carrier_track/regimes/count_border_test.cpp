#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

/// The fewest collisions in a turn, of many phases.
int least_of(const DisturbedMotion& motion) {
  int least = 1000;
  for (int k = 0; k < 20'000; ++k) {
    const double phase = 2 * std::numbers::pi * k / 20'000;
    least = std::min(least, turn_at(motion, phase).collisions);
  }
  return least;
}

TEST(CountBorder, IsWhereTheFirstPhaseCountsMore) {
  Scene machine = default_machine();
  machine.disturbance = 1;
  const DisturbedMotion near = disturbed_motion(at_speed(machine, 8.05));
  const DisturbedMotion far = disturbed_motion(at_speed(machine, 8.0779));
  const auto border = count_border(near, far, 3, Extreme::most);
  ASSERT_TRUE(border);
  EXPECT_EQ(border->kind, RegimeEnd::counting_limit);
  EXPECT_GT(border->omega, near.omega());
  EXPECT_LT(border->omega, far.omega());
  EXPECT_EQ(border->before.most, 2);
  EXPECT_EQ(border->after.most, 3);
}

TEST(CountBorder, MayBeBeforeTheMotionsWhereSuchTurnsBeganUnseen) {
  const Scene machine = random_disturbed_machine(2);
  DisturbedMotion near = disturbed_motion(at_speed(machine, 0.3626));
  near.least = 2;  // as if no even phase had met it
  near.turns.erase(std::remove_if(near.turns.begin(), near.turns.end(),
                                  [](const auto& turn) { return turn.collisions < 2; }),
                   near.turns.end());
  near.known.clear();
  DisturbedMotion far = disturbed_motion(at_speed(machine, 0.3700));
  ASSERT_EQ(far.least, 1);
  const auto border = count_border(near, far, 2, Extreme::least);
  ASSERT_TRUE(border);
  EXPECT_LT(border->omega, near.omega());
  EXPECT_EQ(border->before.least, 2);
  EXPECT_EQ(border->after.least, 1);
  EXPECT_FALSE(border->after.watched.empty());
  EXPECT_EQ(least_of(disturbed_motion(at_speed(machine, border->omega * (1 - 1e-4)))), 2);
  EXPECT_EQ(least_of(disturbed_motion(at_speed(machine, border->omega * (1 + 1e-4)))), 1);
}

TEST(CountBorder, IsNothingIfNoTurnCountsSo) {
  Scene machine = default_machine();
  machine.disturbance = 1;
  const DisturbedMotion near = disturbed_motion(at_speed(machine, 7.0));
  DisturbedMotion far = disturbed_motion(at_speed(machine, 7.1));
  far.most = 3;  // which no phase has
  EXPECT_FALSE(count_border(near, far, 3, Extreme::most));
}

}  // namespace
}  // namespace ricochet::carrier_track
