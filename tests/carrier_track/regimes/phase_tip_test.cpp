#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/regimes/random_machine.h"

namespace ricochet::carrier_track {
namespace {

DisturbedMotion motion_at(const std::string& id, double omega) {
  const auto& cases = all_cases();
  const auto found =
      std::find_if(cases.begin(), cases.end(), [&](const auto& one) { return one.id == id; });
  return disturbed_motion(at_speed(scene_of(*found, default_machine()), omega));
}

/// A phase of a turn in which the impact counts so; -1 if there is none.
double phase_beyond(const DisturbedMotion& motion, int rank, Extreme extreme) {
  for (int k = 0; k < 1000; ++k) {
    const double phase = 2 * std::numbers::pi * k / 1000;
    if (is_beyond(extreme, margin_of(motion.machine, turn_at(motion, phase), rank))) return phase;
  }
  return -1;
}

/// Turns at 2,000 phases around that of a tip in which the impact counts so.
int beyond_near(const DisturbedMotion& motion, const PhaseTip& tip, double omega, int rank,
                Extreme extreme) {
  std::vector<Scene> scenes;
  for (int k = -1000; k <= 1000; ++k) {
    scenes.push_back(machine_at(motion, omega, tip.phase + 2e-5 * k));
  }
  int count = 0;
  for (const DisturbedTurn& turn : turns_of(scenes, motion.turns_before)) {
    if (is_beyond(extreme, margin_of(motion.machine, turn, rank))) ++count;
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
    const double phase = phase_beyond(motion, a.rank, a.extreme);
    const auto tip = phase_tip(motion, a.rank, a.extreme, phase, a.until);
    ASSERT_TRUE(tip) << a.from;
    ASSERT_TRUE(tip->is_reached) << a.from;
    const double outwards = a.until > a.from ? 1e-9 : -1e-9;
    EXPECT_EQ(beyond_near(motion, *tip, tip->omega * (1 + outwards), a.rank, a.extreme), 0);
    EXPECT_GT(beyond_near(motion, *tip, tip->omega * (1 - outwards), a.rank, a.extreme), 0);
  }
}

TEST(PhaseTip, IsFollowedWhereFewPhasesCountSoAndDriftWithTheSpeed) {
  // From 0.36103 rad/s on, a few phases have one collision; at 0.3650 others than at 0.3611.
  const DisturbedMotion motion = disturbed_motion(at_speed(random_disturbed_machine(2), 0.3650));
  const auto is_in = [&](double omega, double phase) {
    const Scene machine = machine_at(motion, omega, phase);
    const DisturbedTurn turn = turns_of({&machine, 1}, motion.turns_before).front();
    return is_beyond(Extreme::least, margin_of(machine, turn, 2));
  };
  const double phase = phase_beyond(motion, 2, Extreme::least);
  const auto tip = phase_tip(motion, 2, Extreme::least, phase, 0.3600);
  ASSERT_TRUE(tip);
  ASSERT_TRUE(tip->is_reached);
  EXPECT_NEAR(tip->omega, 0.36103, 1e-5);
  EXPECT_FALSE(is_in(0.3650, tip->phase));
  for (const double away : {1e-9, 1e-7, 1e-5}) {
    const double omega = tip->omega * (1 + away);
    EXPECT_TRUE(is_in(omega, tip->phase + tip->drift * (omega - tip->omega))) << away;
  }
  for (int k = -1000; k <= 1000; ++k) {
    EXPECT_FALSE(is_in(tip->omega * (1 - 1e-7), tip->phase + 1e-6 * k)) << k;
  }
}

TEST(PhaseTip, IsNotReachedIfTheSearchEndsBefore) {
  const DisturbedMotion motion = motion_at("C7", 2.8970);
  const double phase = phase_beyond(motion, 1, Extreme::least);
  const auto tip = phase_tip(motion, 1, Extreme::least, phase, 2.8971);
  ASSERT_TRUE(tip);
  EXPECT_FALSE(tip->is_reached);
  EXPECT_EQ(tip->omega, 2.8971);
}

TEST(PhaseTip, NeedsATurnThatCountsSo) {
  EXPECT_FALSE(phase_tip(motion_at("C7", 2.8970), 1, Extreme::least, 0.0, 2.8985));
}

}  // namespace
}  // namespace ricochet::carrier_track
