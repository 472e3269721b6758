#include <gtest/gtest.h>

#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

TEST(ObservedTurn, HasTheNumbersOfTheOrbitWhereNothingDisturbs) {
  Scene machine = default_machine();
  machine.omega = 7;
  const SteadyMotion motion = steady_motion(machine);
  const std::vector<double> phases = {0, 1};
  const auto turns = observed_turns(motion.orbit, phases, 1, 3);
  ASSERT_EQ(turns.size(), 6U);
  for (const ObservedTurn& observed : turns) {
    EXPECT_EQ(observed.turn.collisions, motion.collisions);
    EXPECT_NEAR(observed.energy / motion.energy, 1, 1e-9);
    EXPECT_NEAR(observed.share_at_rest, motion.share_at_rest, 1e-9);
    EXPECT_NEAR(observed.turn.speeds.front() / motion.fastest_impact(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
