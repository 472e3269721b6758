#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/carrier_track/identification/example_record.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"

namespace ricochet::carrier_track {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

KnockRecord recorded(const SensorModel& sensor) {
  KnockRecord record = example_record(sensor);
  take_out_sensor_faults(record);
  return record;
}

/// Echoes of several delays and ratios, with strengths and without, at most 7 % of the
/// knocks away from what the sensor records without echoes.
TEST(SensorFaults, EchoesAreLeftOut) {
  for (const double delay : {1.5e-3, 4e-3, 9e-3, 25e-3}) {
    for (const double ratio : {0.3, 0.6}) {
      for (const bool strengths : {false, true}) {
        SensorModel sensor;
        sensor.strengths = strengths;
        const auto clean = static_cast<double>(recorded(sensor).knocks.size());
        sensor.echo_delay = delay;
        sensor.echo_ratio = ratio;
        const KnockRecord record = recorded(sensor);
        EXPECT_NEAR(static_cast<double>(record.knocks.size()) / clean, 1, 0.07)
            << delay << " " << ratio << " " << strengths;
        ASSERT_FALSE(record.notes.empty()) << delay << " " << ratio << " " << strengths;
        EXPECT_THAT(record.notes[0], HasSubstr("echoes"));
      }
    }
  }
}

TEST(SensorFaults, ReboundsAreNoEchoes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const double jitter : {1e-5, 1e-3}) {
      SensorModel sensor;
      sensor.jitter = jitter;
      KnockRecord record = example_record(sensor, seed);
      const std::size_t before = record.knocks.size();
      take_out_sensor_faults(record);
      EXPECT_EQ(record.knocks.size(), before) << seed;
    }
  }
}

/// Here the pairs of knocks within the longest delay would take gigabytes.
TEST(SensorFaults, EchoesAreNotLookedForInARecordThatIsTooDense) {
  KnockRecord record{{}, {{0, 4}}, 0, 10};
  for (int k = 0; k < 1'000'000; ++k) record.knocks.push_back({1e-5 * k});
  take_out_sensor_faults(record);
  EXPECT_EQ(record.knocks.size(), 1'000'000U);
  EXPECT_TRUE(record.notes.empty());
}

TEST(SensorFaults, AtOneSpeedReboundsAreLeftAlone) {
  SensorModel sensor;
  sensor.jitter = 1e-5;
  Random random(1);
  KnockRecord record = synthetic_knocks(knocking_machine(), {{0, 4}, {30, 4}}, sensor, random);
  const std::size_t before = record.knocks.size();
  take_out_sensor_faults(record);
  EXPECT_EQ(record.knocks.size(), before);
  ASSERT_FALSE(record.notes.empty());
  EXPECT_THAT(record.notes[0], HasSubstr("taken for rebounds"));
}

TEST(SensorFaults, OfRowsAtOneTimeTheStrongestStays) {
  KnockRecord record{{{1, 0.1}, {1, 0.3}, {1, 0.2}, {2, 0.1}}, {{0, 3}}, 0, 3, {}};
  take_out_sensor_faults(record);
  ASSERT_EQ(record.knocks.size(), 2U);
  EXPECT_EQ(record.knocks[0].strength, 0.3);
  EXPECT_THAT(record.notes, ElementsAre(HasSubstr("2 rows")));
  EXPECT_EQ(record.dead_time, 0.05);
}

TEST(SensorFaults, DeadTimeAndSaturationAreFound) {
  SensorModel sensor;
  sensor.strengths = true;
  sensor.dead_time = 15e-3;
  sensor.saturation = 0.05;
  const KnockRecord record = recorded(sensor);
  EXPECT_GE(record.dead_time, 15e-3);
  EXPECT_LE(record.dead_time, 50e-3);
  EXPECT_EQ(record.saturation, 0.05);
  EXPECT_EQ(recorded({}).saturation, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ricochet::carrier_track
