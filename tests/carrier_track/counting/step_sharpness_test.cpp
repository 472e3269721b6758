#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "problems/carrier_track/counting/staircase.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

/// A staircase that is known at every speed, scanned to 18 rad/s.
SpeedScan known_staircase(const std::function<double(double omega)>& count) {
  SpeedScan scan{0.01, {}};
  for (int k = 1; k <= 1800; ++k) {
    scan.counts.push_back(static_cast<int>(std::floor(count(0.01 * k) + 1e-9)));
  }
  return scan;
}

TEST(StepSharpness, OfOneJumpIsAStepWithoutWidth) {
  const auto scan = known_staircase([](double w) { return w < 9 ? 5 : 8; });
  const auto found = step_sharpness(scan, 8.995, 7.5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->threshold, 8.995);
  EXPECT_EQ(found->before, 5);
  EXPECT_EQ(found->after, 8);
  EXPECT_EQ(found->width, 0);
  EXPECT_EQ(found->persistence, 1);
  EXPECT_EQ(found->rise, Rise::step);
}

TEST(StepSharpness, OfARampIsTheClimbBetweenTheMiddlesOfItsStretches) {
  // The count 10 w, more than 20 from 2.1 rad/s on: medians at 1.75 and 2.62 rad/s.
  const auto found = step_sharpness(known_staircase([](double w) { return 10 * w; }), 2.095, 20);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->before, 17);
  EXPECT_EQ(found->after, 26);
  EXPECT_NEAR(found->width, 2.6 - 1.8, 1e-9);  // from the first 18 to the first 26
  EXPECT_EQ(found->persistence, 1);
  EXPECT_EQ(found->rise, Rise::climb);
}

TEST(StepSharpness, OfAShortRampBetweenLevelsIsItsLength) {
  const auto ramp = [](double length) {
    return known_staircase(
        [=](double w) { return w < 3 ? 6 : std::min(12.0, 6 + 6 * (w - 3) / length); });
  };
  // From the first 7, a sixth up the ramp, to its end.
  const auto steep = step_sharpness(ramp(0.3), 3.195, 9);
  EXPECT_NEAR(steep->width, 0.3 * 5 / 6, 1e-9);
  EXPECT_EQ(steep->rise, Rise::step);
  const auto gentle = step_sharpness(ramp(0.6), 3.395, 9);
  EXPECT_NEAR(gentle->width, 0.6 * 5 / 6, 1e-9);
  EXPECT_EQ(gentle->rise, Rise::climb);
}

TEST(StepSharpness, OfWhatSoonIsQuietAgainIsNone) {
  // Loud from 4 to 4.5 rad/s, and not again before 6: a quarter of the stretch.
  const auto scan = known_staircase([](double w) { return w < 4 || w >= 4.5 ? 5 : 9; });
  const auto found = step_sharpness(scan, 3.995, 7.5);
  EXPECT_NEAR(found->persistence, 0.25, 0.01);
  EXPECT_EQ(found->after, 5);
  EXPECT_EQ(found->rise, Rise::none);
}

TEST(StepSharpness, OfASmallStepThatPassesTheLimitIsAClimb) {
  // Seven to eight is sharp, and louder than 7.5, but no significant increase by itself.
  const auto scan = known_staircase([](double w) { return w < 5 ? 7 : 8; });
  const auto found = step_sharpness(scan, 4.995, 7.5);
  EXPECT_EQ(found->width, 0);
  EXPECT_EQ(found->persistence, 1);
  EXPECT_EQ(found->rise, Rise::climb);
}

TEST(StepSharpness, IsNotWidenedByLoneSpeeds) {
  SpeedScan scan = known_staircase([](double w) { return w < 9 ? 5 : 8; });
  for (const std::size_t k : {700U, 800U}) scan.counts[k] = 6;
  for (const std::size_t k : {1000U, 1100U}) scan.counts[k] = 5;
  const auto found = step_sharpness(scan, 8.995, 7.5);
  EXPECT_EQ(found->width, 0);
  EXPECT_LT(found->persistence, 1);
  EXPECT_EQ(found->rise, Rise::step);
}

TEST(StepSharpness, LooksAsFarAsItReachesAndAsTheScanGoes) {
  // Loud again above 12 rad/s only: seen from 9, within a half and not within a fifth.
  const auto scan = known_staircase([](double w) { return w < 9 || w >= 12 ? 5 : 8; });
  EXPECT_EQ(step_sharpness(scan, 8.995, 7.5, 1.2)->persistence, 1);
  EXPECT_LT(step_sharpness(scan, 8.995, 7.5, 1.5)->persistence, 0.9);
  const auto late = known_staircase([](double w) { return w < 17 ? 5 : 8; });
  EXPECT_EQ(step_sharpness(late, 16.995, 7.5)->persistence, 1);
  EXPECT_FALSE(step_sharpness(late, 18.5, 7.5));
  EXPECT_FALSE(step_sharpness(late, 0.005, 7.5));
}

}  // namespace
}  // namespace ricochet::carrier_track
