#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/identification/knock_problem.h"
#include "src/identification/knock_fit.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;

TEST(FitStarts, FindThePlatesAngleUpToHalfATurnAndItsSpeed) {
  Random random(3);
  Scene machine = knocking_machine();
  machine.phase = 2;
  KnockRecord record = synthetic_knocks(machine, {{0, 3}, {30, 6}}, {}, random);
  for (SpeedKnot<double>& knot : record.speed) knot.omega /= 1.007;
  const KnockLoss loss(knocking_machine(), record);
  const std::vector<Vector> starts = fit_starts(loss, 3, random);
  ASSERT_EQ(starts.size(), 3U);
  EXPECT_NEAR(std::exp(starts[0][4]), 1.007, 1e-3);
  EXPECT_NEAR(std::remainder(starts[0][3] - 2, std::numbers::pi), 0, 0.3);
}

TEST(FitStarts, KeepWhatMarksSay) {
  Random random(3);
  SensorModel sensor;
  sensor.mark_jitter = 1e-3;
  const KnockRecord record = example_record(sensor);
  const KnockLoss loss(knocking_machine(), record);
  for (const Vector& start : fit_starts(loss, 3, random)) {
    EXPECT_EQ(start[3], record.plate->phase);
    EXPECT_NEAR(start[4], record.plate->log_speed, 1e-12);
  }
}

/// An elastic carrier would knock without end.
TEST(FitStarts, AreWithinTheLimitsOfASearch) {
  Random random(3);
  const KnockRecord record = example_record();
  Scene elastic = knocking_machine();
  elastic.restitution_lower = elastic.restitution_upper = 1 - 1e-6;
  const KnockLoss loss(elastic, record);
  EXPECT_GT(unknowns_at(loss.guess()).restitution, 0.985);
  const std::vector<Vector> starts = fit_starts(loss, 40, random);
  ASSERT_FALSE(starts.empty());
  for (const Vector& start : starts) {
    EXPECT_EQ(start, within_limits(start));
    EXPECT_LT(unknowns_at(start).restitution, 0.983);
  }
}

}  // namespace
}  // namespace ricochet::studies::identification
