#include "problems/carrier_track/regimes/phase_tip.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

DisturbedMotion motion_at(const std::string& id, double omega) {
  return disturbed_motion(at_speed(scene_of(find_case(id), default_machine()), omega));
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

struct Search {
  std::string id;  // of the case
  double from, until;
  int rank;
  Extreme extreme;
};

TEST(PhaseTip, IsTheLastSpeedAtWhichSomePhaseCountsSo) {
  // Margins that are smooth, and some beside a jump.
  for (const Search& a : {Search{"C5", 8.0785, 8.0770, 3, Extreme::most},
                          Search{"C7", 2.8970, 2.8985, 1, Extreme::least},
                          Search{"C5", 1.4950, 1.5100, 1, Extreme::least}}) {
    const DisturbedMotion motion = motion_at(a.id, a.from);
    ASSERT_TRUE(has_beyond(motion, a.rank, a.extreme)) << a.from;
    const PhaseTip tip = phase_tip(motion, motion_at(a.id, a.until), a.rank, a.extreme);
    ASSERT_TRUE(tip.is_reached) << a.from;
    const double outwards = a.until > a.from ? 1e-9 : -1e-9;
    EXPECT_EQ(beyond_near(motion, tip, tip.omega * (1 + 2 * outwards), a.rank, a.extreme), 0);
    EXPECT_GT(beyond_near(motion, tip, tip.omega * (1 - outwards), a.rank, a.extreme), 0);
  }
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

TEST(PhaseTip, IsNotReachedIfTheSearchEndsBefore) {
  const PhaseTip tip =
      phase_tip(motion_at("C7", 2.8970), motion_at("C7", 2.8971), 1, Extreme::least);
  EXPECT_FALSE(tip.is_reached);
  EXPECT_EQ(tip.omega, 2.8971);
}

}  // namespace
}  // namespace ricochet::carrier_track
