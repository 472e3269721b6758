#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/regimes/sampled_turns.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

DisturbedMotion disturbed() {
  Scene machine = default_machine();
  machine.disturbance = 1;
  machine.omega = 8.0779;
  return disturbed_motion(machine);
}

TEST(PhaseWindow, HasTheLeastMarginOfItsPhases) {
  const DisturbedMotion motion = disturbed();
  int inside = 0;
  for (const double sign : {1.0, -1.0}) {
    for (int k = 0; k < 64; ++k) {
      const double centre = 0.1 * k;
      const PhaseWindow window(motion, 3, centre, 0.1);
      ASSERT_TRUE(window.is_known());
      if (window.error() > 1e-11) continue;
      const auto valley = window.least(sign);
      const auto at = [&](double phase) {
        return sign * margin_of(motion.machine, turn_at(motion, phase), 3);
      };
      // The margin there is the true one, and no other is less.
      EXPECT_NEAR(valley.value, at(valley.phase), 1e-11);
      for (int i = 0; i <= 20; ++i) {
        EXPECT_LE(valley.value, at(centre + 0.01 * (i - 10)) + 1e-11);
      }
      inside += valley.inside ? 1 : 0;
    }
  }
  EXPECT_GE(inside, 4);
}

TEST(PhaseWindow, KnowsHowSmoothTheMarginIs) {
  const DisturbedMotion motion = disturbed();
  EXPECT_GT(PhaseWindow(motion, 3, 1, 1).error(), 1e-9);
  EXPECT_LT(PhaseWindow(motion, 3, 1, 0.01).error(), 1e-11);
  EXPECT_FALSE(PhaseWindow(motion, 1000, 1, 0.1).is_known());
}

}  // namespace
}  // namespace ricochet::carrier_track
