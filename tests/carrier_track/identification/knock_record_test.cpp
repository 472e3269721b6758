#include "problems/carrier_track/identification/knock_record.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace ricochet::carrier_track {
namespace {

const std::vector<SpeedKnot<double>> up_and_on = {{1, 2}, {3, 6}};

TEST(KnockRecord, InterpolatesSpeedsAndHoldsThemOutside) {
  EXPECT_EQ(speed_at(up_and_on, 0), 2);
  EXPECT_EQ(speed_at(up_and_on, 2), 4);
  EXPECT_EQ(speed_at(up_and_on, 9), 6);
}

TEST(KnockRecord, IntegratesSpeedsToAngles) {
  EXPECT_NEAR(angle_between(up_and_on, 0, 1), 2, 1e-14);
  EXPECT_NEAR(angle_between(up_and_on, 0, 5), 2 + 8 + 12, 1e-14);
  EXPECT_NEAR(angle_between(up_and_on, 1.5, 2.5), 4, 1e-14);
}

/// Marks of a plate whose speed is 1 % above the recorded 2 rad/s; alpha is 0.3 rad at 0 s. One
/// mark is missed.
std::vector<double> marks_of(double error) {
  std::vector<double> marks;
  for (int k = 1; k < 12; ++k) {
    if (k == 5) continue;
    marks.push_back((2 * std::numbers::pi * k - 0.3) / 2.02 + (k % 2 == 0 ? error : -error));
  }
  return marks;
}

TEST(KnockRecord, FindsPhaseAndSpeedFromMarks) {
  const KnockRecord record{{}, {{0, 2}}, 0, 40, {}};
  const PlateMeasurement plate = plate_measurement(record, marks_of(0), 0);
  EXPECT_NEAR(std::remainder(plate.phase - 0.3, 2 * std::numbers::pi), 0, 1e-9);
  EXPECT_NEAR(std::exp(plate.log_speed), 1.01, 1e-12);
  EXPECT_NEAR(
      std::remainder(plate_measurement(record, marks_of(0), 0.5).phase - 0.8, 2 * std::numbers::pi),
      0, 1e-9);
}

/// Marks on a ramp that lag the speeds by 3 ms shift neither phase nor speed, if lags are allowed
/// for; the phase is known no better than the angle at a mark.
TEST(KnockRecord, AllowsForALagAndAnUncertainAngleOfMarks) {
  KnockRecord record{{}, {{0, 2}, {40, 12}}, 0, 40, {}};
  std::vector<double> marks;
  for (int k = 1; k < 40; ++k) {
    const double angle = 2 * std::numbers::pi * k - 0.3;
    marks.push_back(-8 + std::sqrt(64 + 8 * angle) + 3e-3 + (k % 2 == 0 ? 1e-4 : -1e-4));
  }
  const PlateMeasurement exact = plate_measurement(record, marks, 0);
  record.lag_deviation = 5e-3;
  const PlateMeasurement lagging = plate_measurement(record, marks, 0, 0.05);
  EXPECT_NEAR(std::remainder(lagging.phase - 0.3, 2 * std::numbers::pi), 0, 1e-3);
  EXPECT_NEAR(lagging.log_speed, 0, 1e-5);
  EXPECT_GT(std::abs(exact.log_speed), 1e-5);
  EXPECT_NEAR(lagging.information.inverse()(0, 0), 0.05 * 0.05, 0.05 * 0.05 * 0.01);
  EXPECT_LT(lagging.deviation, 2e-3);
}

TEST(KnockRecord, KnowsThePlateAsWellAsTheMarksAgree) {
  const KnockRecord record{{}, {{0, 2}}, 0, 40, {}};
  const PlateMeasurement fine = plate_measurement(record, marks_of(1e-3), 0);
  const PlateMeasurement coarse = plate_measurement(record, marks_of(2e-3), 0);
  EXPECT_NEAR(fine.deviation, 2.02e-3, 0.3e-3);
  EXPECT_NEAR(fine.information(0, 0) / coarse.information(0, 0), 4, 1e-3);
  EXPECT_NEAR(fine.information(0, 0), 10 / std::pow(fine.deviation, 2), 1e-3);
}

}  // namespace
}  // namespace ricochet::carrier_track
