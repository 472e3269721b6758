#include <gtest/gtest.h>

#include "problems/carrier_track/regimes/basins.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

TEST(Anatomy, OfTheFirstCaseIsADecayAndTwoCollisionsATurn) {
  Scene machine = default_machine();
  machine.omega = 5;
  const Recording recording = simulate(machine);
  const auto anatomy = anatomy_of(machine, recording.impacts);
  ASSERT_TRUE(anatomy);
  EXPECT_EQ(anatomy->of_start + anatomy->of_long_run, recording.count);
  EXPECT_EQ(anatomy->per_turn, 2);
  // A later window of as many turns has nothing but the long run.
  EXPECT_GT(anatomy->of_start, 0);
  Scene longer = machine;
  longer.window = Revolutions{100 + 1.3775349971979638};
  Scene before = machine;
  before.window = Revolutions{100};
  EXPECT_EQ(simulate(longer).count - simulate(before).count, anatomy->of_long_run);
}

TEST(Anatomy, ALongWindowHasAsMuchDecayAsAShortOne) {
  Scene machine = default_machine();
  machine.omega = 3;
  machine.window = Revolutions{3};
  const auto brief = anatomy_of(machine, simulate(machine).impacts);
  machine.window = Revolutions{30};
  const auto longer = anatomy_of(machine, simulate(machine).impacts);
  ASSERT_TRUE(brief && longer);
  EXPECT_EQ(brief->of_start, longer->of_start);
  EXPECT_EQ(longer->of_long_run - brief->of_long_run, 2 * 27);
}

TEST(Anatomy, IsUnknownWithoutAPeriod) {
  Scene machine = default_machine();
  machine.disturbance = 0.1;
  machine.omega = 5.0123;
  EXPECT_FALSE(anatomy_of(machine, simulate(machine).impacts));
}

}  // namespace
}  // namespace ricochet::carrier_track
