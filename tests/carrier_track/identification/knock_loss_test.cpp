#include "problems/carrier_track/identification/knock_loss.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

using testing::Contains;
using testing::Not;

void expect_exact_slopes(const KnockRecord& record, Vector x, double blur) {
  const KnockLoss loss(knocking_machine(), record);
  if (record.has_strengths()) x[8] = loss.guess()[8];
  x[2] += 0.02;
  Vector slopes;
  loss.at(x, blur, &slopes);
  for (const Eigen::Index i : loss.free()) {
    const double step = i == coordinate::speed_factor || i == coordinate::drift ? 1e-9
                        : i == coordinate::lag                                  ? 1e-8
                                                                                : 1e-6;
    Vector up = x, down = x;
    up[i] += step;
    down[i] -= step;
    const double expected = (loss.at(up, blur) - loss.at(down, blur)) / (2 * step);
    EXPECT_NEAR(slopes[i], expected, 1e-4 * (1 + std::abs(expected))) << "coordinate " << i;
  }
}

TEST(KnockLoss, HasExactSlopes) {
  const KnockRecord record = example_record();
  for (const double blur : {0.0, 0.02}) expect_exact_slopes(record, example_point(record), blur);
}

TEST(KnockLoss, HasExactSlopesWithStrengthsAndMarks) {
  SensorModel sensor;
  sensor.strengths = true;
  sensor.mark_jitter = 1e-3;
  const KnockRecord record = example_record(sensor);
  Vector x = example_point(record);
  x.segment(3, 2) << record.plate->phase + 1e-3, record.plate->log_speed;
  expect_exact_slopes(record, x, 0);
}

/// Lag, drift, a deaf sensor, a wall each, saturated strengths.
TEST(KnockLoss, HasExactSlopesOfEachFaultOfAMeasurement) {
  for (const bool strengths : {false, true}) {
    SensorModel sensor;
    sensor.strengths = strengths;
    sensor.mark_jitter = 1e-3;
    sensor.lag = 2e-3;
    sensor.drift = 1e-4;
    sensor.dead_time = 12e-3;
    sensor.saturation = 0.06;
    KnockRecord record = example_record(sensor);
    record.lag_deviation = 5e-3;
    record.dead_time = sensor.dead_time;
    if (strengths) record.saturation = sensor.saturation;
    Vector x = example_point(record);
    x.segment(3, 2) << record.plate->phase + 1e-3, record.plate->log_speed;
    x[coordinate::lag] = 1.5e-3;
    x[coordinate::drift] = 5e-5;
    x[coordinate::upper_share] = 1;
    expect_exact_slopes(record, x, 0);
    expect_exact_slopes(record, x, 0.02);
  }
}

TEST(KnockLoss, FitsWhatTheSensorTells) {
  const KnockRecord times = example_record();
  EXPECT_THAT(KnockLoss(knocking_machine(), times).free(), Contains(8));
  EXPECT_THAT(KnockLoss(knocking_machine(), times).free(), Not(Contains(9)));
  SensorModel sensor;
  sensor.strengths = true;
  const KnockRecord strengths = example_record(sensor);
  EXPECT_THAT(KnockLoss(knocking_machine(), strengths).free(), Not(Contains(8)));
  EXPECT_THAT(KnockLoss(knocking_machine(), strengths).free(), Contains(9));
}

/// The mean of the slopes over records is zero at the truth, and their covariance that of the
/// scores: what the intervals rest on.
TEST(KnockLoss, HasScoresOfTheExpectedSpread) {
  constexpr int records = 60;
  const KnockRecord first = example_record();
  Vector x = example_point(first);
  Vector sum = Vector::Zero(knock_unknowns), squares = sum, variance;
  for (int k = 0; k < records; ++k) {
    const KnockRecord record = example_record({}, static_cast<std::uint64_t>(k + 1));
    const KnockLoss loss(knocking_machine(), record);
    Vector slopes;
    loss.at(x, 0, &slopes);
    sum += slopes;
    squares += slopes.cwiseProduct(slopes);
    if (k == 0) variance = loss.information(x).score.diagonal();
  }
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(sum[i]) / records, 3.5 * std::sqrt(variance[i] / records)) << i;
    EXPECT_NEAR(squares[i] / records / variance[i], 1, 0.7) << i;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
