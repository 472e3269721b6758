#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/identification/knock_problem.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

/// The deviation of a coordinate if a record goes on for a step of this speed.
double deviation_with(const KnockRecord& record, double omega, Eigen::Index i) {
  KnockRecord longer = record;
  longer.speed.push_back({record.to + 1e-3, omega});
  longer.to = record.to + next_step_seconds;
  const KnockLoss loss(knocking_machine(), longer);
  return std::sqrt(covariance_of(loss.information(example_point(record)), loss.free())(i, i));
}

TEST(NextSpeed, PredictsWhatALongerRecordWouldKnow) {
  const KnockRecord record = example_record();
  const KnockLoss loss(knocking_machine(), record);
  const Vector x = example_point(record);
  Vector friction = Vector::Zero(machine_constants);
  friction[1] = 1;
  const std::optional<NextSpeed> next = next_speed(loss, x, friction, 18);
  ASSERT_TRUE(next);
  EXPECT_LT(next->deviation, next->now);
  EXPECT_NEAR(next->now, std::sqrt(covariance_of(loss.information(x), loss.free())(1, 1)), 1e-12);
  EXPECT_NEAR(deviation_with(record, next->omega, 1) / next->deviation, 1, 0.1);
  for (const double other : {0.7, 1.5}) {
    EXPECT_GT(deviation_with(record, other * next->omega, 1), 0.95 * next->deviation);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
