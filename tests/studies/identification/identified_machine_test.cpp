#include "src/identification/identified_machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/solver.h"
#include "tests/carrier_track/identification/example_record.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"

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
  EXPECT_NEAR(machine.missed_share, 0.05, 0.12);  // each wall has few knocks
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
  EXPECT_THAT(machine.contradictions, Contains(HasSubstr("explains only")));
}

/// A minute from 2 to 15 rad/s, as read_knock_record() has it.
KnockRecord measured(const SensorModel& sensor, double mark_error, std::uint64_t seed = 7) {
  Random random(seed);
  KnockRecord record = synthetic_knocks(knocking_machine(), {{0, 2}, {60, 15}}, sensor, random);
  record.lag_deviation = usual_lag_deviation;
  record.plate = plate_measurement(record, mark_times(knocking_machine(), record, 1e-3, random),
                                   mark_error, usual_mark_deviation);
  take_out_sensor_faults(record);
  return record;
}

void expect_truth(const KnockRecord& record, const char* what) {
  const KnockLoss loss(knocking_machine(), record);
  const IdentifiedMachine machine = identify(loss, solver_named(usual_solver), 18);
  EXPECT_THAT(machine.contradictions, testing::IsEmpty()) << what;
  const double truths[] = {0.5, 0.2, 0.7e-3};
  for (std::size_t i = 0; i < 3; ++i) {
    const Estimate& e = machine.constants[i];
    EXPECT_LT(std::abs(std::log(e.value / truths[i]) / std::log(e.upper / e.lower)), 0.8)
        << what << ": " << e.name;
  }
}

TEST(IdentifiedMachine, IsFoundThroughFaultsOfTheMeasurement) {
  SensorModel sensor;
  sensor.strengths = true;
  expect_truth(measured(sensor, 0.02), "mark");
  expect_truth(measured(sensor, -0.05), "mark");
  const auto with = [&](const char* what, auto change) {
    SensorModel faulty = sensor;
    change(faulty);
    expect_truth(measured(faulty, 0), what);
  };
  with("late", [](SensorModel& s) { s.lag = 2e-3; });
  with("early", [](SensorModel& s) { s.lag = -5e-3; });
  with("drift", [](SensorModel& s) { s.drift = 1e-4; });
  with("echoes", [](SensorModel& s) { s.echo_delay = 4e-3; });
  with("dead time", [](SensorModel& s) { s.dead_time = 10e-3; });
  with("one wall", [](SensorModel& s) { s.upper_gain = 0.01; });
  with("saturation", [](SensorModel& s) { s.saturation = 0.06; });
}

TEST(IdentifiedMachine, SaysWhatARecordContradicts) {
  SensorModel sensor;
  sensor.strengths = true;
  sensor.lag = 3e-3;
  KnockRecord late = measured(sensor, 0);
  late.lag_deviation = 0;
  const IdentifiedMachine one_clock =
      identify(KnockLoss(knocking_machine(), late), solver_named(usual_solver), 18);
  EXPECT_THAT(one_clock.contradictions, Contains(HasSubstr("one clock")));

  sensor.lag = 0;
  KnockRecord turned = measured(sensor, 0);
  Random random(1);
  turned.lag_deviation = 0;
  turned.plate =
      plate_measurement(turned, mark_times(knocking_machine(), turned, 1e-3, random), 0.03, 0);
  const IdentifiedMachine exact_mark =
      identify(KnockLoss(knocking_machine(), turned), solver_named(usual_solver), 18);
  EXPECT_THAT(exact_mark.contradictions, Contains(HasSubstr("the marks' angle")));
}

}  // namespace
}  // namespace ricochet::studies::identification
