#include "src/identification/identified_machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "problems/carrier_track/identification/safe_speed.h"
#include "ricochet/solvers.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;
using testing::Contains;
using testing::HasSubstr;

TEST(IdentifiedMachine, HasIntervalsOfConstantsAndSafeSpeed) {
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  sensor.strengths = true;
  const KnockRecord record = example_record(sensor);
  const KnockLoss loss(knocking_machine(), record);
  const IdentifiedMachine machine = identify(loss, solver_named(usual_solver), 18);
  ASSERT_EQ(machine.constants.size(), 3U);
  for (const Estimate& e : machine.constants) {
    EXPECT_LT(e.lower, e.value);
    EXPECT_LT(e.value, e.upper);
  }
  EXPECT_EQ(machine.constants[1].assumed, 0.2);
  EXPECT_EQ(machine.scene.friction, machine.constants[1].value);
  ASSERT_TRUE(machine.safe_speed);
  EXPECT_NEAR(machine.safe_speed->value / *safe_speed(machine.scene), 1, 1e-9);
  EXPECT_LT(machine.safe_speed->upper / machine.safe_speed->lower, 1.1);
  ASSERT_TRUE(machine.next);
  EXPECT_EQ(machine.next_target, "safe speed");
  EXPECT_NEAR(machine.missed_share, 0.05, 0.1);
  EXPECT_NEAR(machine.explained_share, 0.95, 0.06);
}

TEST(IdentifiedMachine, SaysWhatOneSpeedCannotTell) {
  Random random(1);
  const KnockRecord record = synthetic_knocks(knocking_machine(), {{0, 3}, {30, 3}}, {}, random);
  const KnockLoss loss(knocking_machine(), record);
  const IdentifiedMachine machine = identify(loss, solver_named(usual_solver), 18);
  EXPECT_THAT(machine.remarks, Contains(HasSubstr("does not determine the clearance")));
}

TEST(IdentifiedMachine, SaysThatItDoesNotExplainARecord) {
  KnockRecord record = example_record();
  Random random(1);
  for (Knock& knock : record.knocks) knock.time = 15 * uniform(random);
  std::ranges::sort(record.knocks, {}, &Knock::time);
  const KnockLoss loss(knocking_machine(), record);
  const IdentifiedMachine machine = identify(loss, solver_named(usual_solver), 18);
  EXPECT_THAT(machine.remarks, Contains(HasSubstr("explains only")));
}

}  // namespace
}  // namespace ricochet::studies::identification
