#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

TEST(DisturbedTurn, HasTheImpactsOfASimulationToTheLastRebound) {
  Scene machine = default_machine();
  machine.disturbance = 0.3;
  machine.restitution_lower = machine.restitution_upper = 0.9;
  machine.omega = 6;
  machine = disturbed_motion(machine).machine;
  const std::vector<double> phases = {0, 0.5, 1, 2, 3, 3.5, 4, 5, 6, 6.2};
  for (const int before : {0, 2}) {
    const auto turns = turns_at_phases(machine, phases, before);
    const auto observed = observed_turns(machine, phases, before, 1);
    ASSERT_EQ(turns.size(), phases.size());
    ASSERT_EQ(observed.size(), phases.size());
    for (std::size_t k = 0; k < phases.size(); ++k) {
      EXPECT_EQ(turns[k].phase, phases[k]);
      EXPECT_EQ(turns[k].collisions, observed[k].turn.collisions);
      ASSERT_LE(turns[k].speeds.size(), observed[k].turn.speeds.size());
      ASSERT_GT(turns[k].speeds.size(), static_cast<std::size_t>(turns[k].collisions));
      EXPECT_EQ(turns[k].impacts.size(), turns[k].speeds.size());
      // None is left out of those that a margin can be taken of.
      const double slowest = std::exp(lowest_margin) * machine.counting_limit;
      const auto& speeds = observed[k].turn.speeds;
      EXPECT_EQ(static_cast<std::ptrdiff_t>(turns[k].speeds.size()),
                std::count_if(speeds.begin(), speeds.end(),
                              [slowest](double speed) { return speed > slowest; }));
      for (std::size_t i = 0; i < turns[k].speeds.size(); ++i) {
        EXPECT_NEAR(turns[k].speeds[i] / observed[k].turn.speeds[i], 1, 1e-12);
      }
    }
  }
}

TEST(DisturbedTurn, IsTheSameAloneAsBesideOthers) {
  Scene machine = default_machine();
  machine.disturbance = 1;
  machine.omega = 8.1;
  machine = disturbed_motion(machine).machine;
  const std::vector<double> phases = {0.1, 1.2, 2.3};
  const auto together = turns_at_phases(machine, phases, 0);
  for (std::size_t k = 0; k < phases.size(); ++k) {
    EXPECT_EQ(together[k].speeds, turns_at_phases(machine, {&phases[k], 1}, 0).front().speeds);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
