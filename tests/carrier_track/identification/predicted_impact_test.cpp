#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/identification/example_record.h"

namespace ricochet::carrier_track {
namespace {

const KnockRecord ramp{{}, {{10, 3}, {25, 6}}, 10, 25, {}};

TEST(PredictedImpacts, AreThoseOfTheSimulation) {
  const Vector x = point_of(guess_of(knocking_machine()));
  const auto impacts = plain_impacts(knocking_machine(), ramp, x, 1e-3);
  // The same machine from rest, two turns before the record.
  const double settling = 4 * std::numbers::pi / 3;
  Scene scene = knocking_machine();
  scene.phase -= 3 * settling;
  scene.profile = {{0, 3}, {settling, 3}, {settling + 15, 6}};
  scene.window = Seconds{settling + 15};
  std::vector<Impact> expected;
  for (const Impact& impact : simulate(scene).impacts) {
    if (impact.speed > 1e-3 && impact.time >= settling) expected.push_back(impact);
  }
  ASSERT_EQ(impacts.size(), expected.size());
  ASSERT_GT(impacts.size(), 30U);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    EXPECT_NEAR(impacts[i].time, expected[i].time - settling + 10, 1e-9);
    EXPECT_NEAR(impacts[i].log_speed, std::log(expected[i].speed), 1e-7);
  }
}

TEST(PredictedImpacts, HaveDerivativesByEveryCoordinate) {
  const Vector x = point_of(guess_of(knocking_machine()));
  const auto impacts = predicted_impacts(knocking_machine(), ramp, x, 1e-3);
  for (Eigen::Index i = 0; i < motion_unknowns; ++i) {
    Vector up = x, down = x;
    const double step = 1e-7;
    up[i] += step;
    down[i] -= step;
    const auto above = plain_impacts(knocking_machine(), ramp, up, 1e-3);
    const auto below = plain_impacts(knocking_machine(), ramp, down, 1e-3);
    ASSERT_EQ(above.size(), impacts.size());
    ASSERT_EQ(below.size(), impacts.size());
    const auto k = static_cast<std::size_t>(i);
    for (std::size_t j = 0; j < impacts.size(); ++j) {
      const double slope = (above[j].time - below[j].time) / (2 * step);
      EXPECT_NEAR(impacts[j].time_slopes[k], slope, 1e-5 * (1 + std::abs(slope))) << i;
      const double speed_slope = (above[j].log_speed - below[j].log_speed) / (2 * step);
      EXPECT_NEAR(impacts[j].log_speed_slopes[k], speed_slope, 1e-4 * (1 + std::abs(speed_slope)))
          << i;
    }
  }
}

TEST(PredictedImpacts, ComeEarlierOnAFasterPlate) {
  const KnockRecord steady{{}, {{0, 4}}, 0, 20, {}};
  KnockUnknowns at = guess_of(knocking_machine());
  const auto slow = plain_impacts(knocking_machine(), steady, point_of(at), 1e-2);
  at.speed_factor = 1.001;
  const auto fast = plain_impacts(knocking_machine(), steady, point_of(at), 1e-2);
  EXPECT_NEAR(fast.back().time / slow.back().time, 1 / 1.001, 1e-4);
}

}  // namespace
}  // namespace ricochet::carrier_track
