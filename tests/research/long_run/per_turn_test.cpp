#include "src/research/long_run/per_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/problems/cases.h"
#include "ricochet/regimes.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;

Scene machine_of(const std::string& id, double omega) {
  return at_speed(scene_of(find_case(id), default_interpretation().scene), omega);
}

TEST(PerTurn, IsWhatTheRegimesHave) {
  for (const char* id : {"C1", "C2", "C4"}) {
    for (const Regime& regime : regimes_of(machine_of(id, 1))) {
      const Scene there = machine_of(id, std::sqrt(regime.from * regime.to));
      EXPECT_EQ(collisions_per_turn(there), regime.collisions_per_turn) << id << there.omega;
      EXPECT_EQ(brief_collisions_per_turn(there, 100), regime.collisions_per_turn)
          << id << there.omega;
    }
  }
}

TEST(PerTurn, IsTheMeanOverThePhasesOfADisturbance) {
  const double some = quiet_up_to(machine_of("C10", 1), 3).value();
  const double between = collisions_per_turn(machine_of("C10", 1.05 * some));
  EXPECT_GT(between, 2);
  EXPECT_LT(between, 4);
  EXPECT_NEAR(brief_collisions_per_turn(machine_of("C10", 1.05 * some), 100), between, 0.5);
  EXPECT_EQ(collisions_per_turn(machine_of("C9", 5)), 2);
  EXPECT_EQ(brief_collisions_per_turn(machine_of("C9", 5), 100), 2);
}

TEST(PerTurn, StopsAtTheMost) {
  EXPECT_EQ(brief_collisions_per_turn(machine_of("C2", 17), 10), 11);
  EXPECT_GT(collisions_per_turn(machine_of("C2", 17)), 11);
}

}  // namespace
}  // namespace ricochet::studies::long_run
