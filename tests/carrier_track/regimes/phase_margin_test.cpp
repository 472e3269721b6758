#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

Scene shaken_at(double omega) {
  Scene machine = default_machine();
  machine.disturbance = 1;
  machine.omega = omega;
  return machine;
}

TEST(PhaseMargin, IsExtremeBetweenTheEvenPhases) {
  const DisturbedMotion motion = disturbed_motion(shaken_at(8.0779));
  for (const Extreme extreme : {Extreme::least, Extreme::most}) {
    double best = extreme == Extreme::least ? 10 : -10;
    for (int k = 0; k < 5000; ++k) {
      const DisturbedTurn turn = turn_at(motion, 2 * std::numbers::pi * k / 5000);
      const double margin = std::log(turn.speeds.at(2) / motion.machine.counting_limit);
      best = extreme == Extreme::least ? std::min(best, margin) : std::max(best, margin);
    }
    // At a kink, where two impacts change places, the even phases miss the extreme by their slope.
    const PhaseMargin margin = extreme_margin(motion, 3, extreme);
    const double beyond = (best - margin.value) * sign_of(extreme);
    EXPECT_NEAR(margin_of(motion.machine, turn_at(motion, margin.phase), 3), margin.value, 1e-9);
    EXPECT_GT(beyond, -1e-9);
    EXPECT_LT(beyond, 2e-6);
  }
}

TEST(PhaseMargin, IsNotBeyondWhatIsTrueWhereAnImpactAppears) {
  // Parabolas through margins of turns with and without an impact would rise above 0. Counted at
  // 40,000 phases.
  const DisturbedMotion motion =
      disturbed_motion(at_speed(scene_of(find_case("C9"), default_machine()), 0.645948));
  EXPECT_GT(sampled_margin(motion, 2, Extreme::most).value, 0.1);
  EXPECT_LT(extreme_margin(motion, 2, Extreme::most).value, 0);
  EXPECT_EQ(motion.most, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
