#include "tests/carrier_track/identification/synthetic_knocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/identification/knock_unknowns.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

TEST(SyntheticKnocks, AreTheImpactsOfAnIdealSensor) {
  SensorModel ideal{0, 0, 0, 6e-3, 0, true, {}};
  const KnockRecord record = example_record(ideal);
  const auto impacts =
      plain_impacts(knocking_machine(), record, point_of(guess_of(knocking_machine())), 6e-3);
  ASSERT_EQ(record.knocks.size(), impacts.size());
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    EXPECT_EQ(record.knocks[i].time, impacts[i].time);
    EXPECT_NEAR(std::log(*record.knocks[i].strength), impacts[i].log_speed, 1e-12);
  }
}

TEST(SyntheticKnocks, AreMissedAndAdded) {
  Random random(1);
  const std::vector<SpeedKnot<double>> speed = {{0, 4}, {300, 4}};
  const auto knocks = [&](double missed, double spurious) {
    return synthetic_knocks(knocking_machine(), speed, {1e-3, missed, spurious, 6e-3, 0, false, {}},
                            random)
        .knocks.size();
  };
  const auto all = static_cast<double>(knocks(0, 0));
  EXPECT_GT(all, 700);
  EXPECT_NEAR(static_cast<double>(knocks(0.3, 0)), 0.7 * all, 0.06 * all);
  EXPECT_NEAR(static_cast<double>(knocks(0, 0.3)), 1.3 * all, 0.06 * all);
}

TEST(SyntheticKnocks, ComeWithMarksOfThePlate) {
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  const KnockRecord record = example_record(sensor);
  ASSERT_TRUE(record.plate);
  EXPECT_NEAR(std::remainder(record.plate->phase - 1, 6.283185307), 0, 0.01);
  EXPECT_NEAR(record.plate->log_speed, 0, 1e-3);
}

}  // namespace
}  // namespace ricochet::carrier_track
