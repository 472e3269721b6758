#include "src/studies/surrogate/growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/suite/machine.h"
#include "src/studies/surrogate/continuity.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::Scene;

TEST(LineFit, FindsTheSlopeOfALineAndNoneOfAPoint) {
  EXPECT_DOUBLE_EQ(*slope_of({{1, 5}, {2, 3}, {4, -1}}), -2);
  // Least squares of 0, 0, 1 over 0, 1, 2: 1/2.
  EXPECT_DOUBLE_EQ(*slope_of({{0, 0}, {1, 0}, {2, 1}}), 0.5);
  EXPECT_FALSE(slope_of({{1, 5}, {2, 3}}));
  EXPECT_FALSE(slope_of({{1, 5}, {1, 3}, {1, 4}}));
}

TEST(Growth, FitsTheRateOfAnExponential) {
  std::vector<Stretched> impacts;
  for (int k = 0; k < 50; ++k) {
    const double time = 0.2 * k;
    impacts.push_back({time, time < 1 ? 1e9 : 1e-6 * std::exp(2.5 * time)});
  }
  EXPECT_NEAR(*rate_of(impacts, 10.0), 2.5, 1e-12);
  impacts.resize(7);  // two of them after the first second
  EXPECT_FALSE(rate_of(impacts, 10.0));
}

TEST(Growth, MovesTheImpactsOfAFreeBodyNotAtAllButInPhase) {
  // Between elastic walls, driven by nothing, impacts keep their times, so that in phase, time x
  // rate, they come later by their time over the rate.
  Scene scene;
  scene.start_velocity = 2.0;
  scene.omega = 5.0;
  scene.window = carrier_track::Seconds{4};
  const auto moved = stretched_by_impact({"free", scene});
  ASSERT_EQ(moved.size(), 8U);
  for (const Stretched& impact : moved) {
    EXPECT_NEAR(impact.length, 2.0 * impact.time / 5.0, 1e-14);
  }
}

TEST(Growth, FollowsTheExponentInChaosAndNothingWhereTheBodyRests) {
  const GrowthCell chaotic = growth_of(shaken_gaps().front(), 50);
  ASSERT_TRUE(chaotic.sensitivity.chaotic());
  EXPECT_NEAR(*chaotic.rate / *chaotic.sensitivity.exponent(), 1, 0.15);
  EXPECT_EQ(chaotic.trust.doubt, GradientDoubt::sensitive);
  EXPECT_GT(chaotic.error_of(chaotic.within), useless);
  const Scene scene = carrier_track::at_speed(
      scene_of(carrier_track::find_case("C2"), carrier_track::default_machine()), 6.0);
  const GrowthCell calm = growth_of({"C2", scene}, 20);
  EXPECT_FALSE(calm.sensitivity.exponent());
  EXPECT_NEAR(*calm.rate, 0, 0.05);
  EXPECT_LT(calm.error_of(calm.within), 1e-6);
}

TEST(Growth, IsAskedInTheWindowGiven) {
  // At 20 periods a difference with steps within the reach is still right, and a blind one not.
  const GrowthCell cell = growth_of(shaken_gaps().front(), 20);
  EXPECT_LT(cell.error_of(cell.within), 1e-4);
  EXPECT_GT(cell.error_of(cell.blind), useless);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
