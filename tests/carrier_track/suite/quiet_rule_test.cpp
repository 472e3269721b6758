#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr double scan_step = 1e-3;

Scene machine_with(double restitution, double friction, double disturbance = 0) {
  return scene_of({"mine", restitution, friction, disturbance, {}}, default_machine());
}

double fastest_up_to(const Scene& scene, double limit) {
  const SpeedScan scan = scan_speeds(scene, scan_step, fastest_speed);
  double fastest = 0;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.counts[k] <= limit) fastest = scan.omega(k);
  }
  return fastest;
}

/// The window's fastest quiet speed is the border of the long run, whatever the restitution.
TEST(QuietRule, GivesTheWindowTheBorderOfTheLongRun) {
  for (const double restitution : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (const double friction : {0.1, 0.4}) {
      const Scene scene = machine_with(restitution, friction);
      const QuietRule rule = quiet_rule_of(scene, scan_step);
      ASSERT_TRUE(rule.threshold);
      EXPECT_EQ(rule.threshold, quiet_up_to(scene, quiet_per_turn));
      EXPECT_EQ(rule.limit - 0.5, std::floor(rule.limit)) << "half a collision above a count";
      EXPECT_NEAR(fastest_up_to(scene, rule.limit), *rule.threshold, scan_step)
          << restitution << ", " << friction;
    }
  }
}

/// A disturbance shows the window one of its phases, and the long run all: the window can only be
/// quieter.
TEST(QuietRule, IsOfTheLoudestPhaseOfADisturbance) {
  const Scene scene = machine_with(0.1, 0.1, 1);
  const QuietRule rule = quiet_rule_of(scene, scan_step);
  const double fastest = fastest_up_to(scene, rule.limit);
  EXPECT_GE(fastest, *rule.threshold - scan_step);
  EXPECT_NEAR(fastest, *rule.threshold, 0.02);
}

TEST(QuietRule, TakesTheThresholdOfHardWallsForEveryFidelity) {
  Scene planar = machine_with(0.1, 0.4);
  const std::optional<double> hard = quiet_rule_of(planar, scan_step).threshold;
  planar.fidelity = Fidelity::planar;
  planar.across = Across<double>{};
  EXPECT_EQ(quiet_rule_of(planar, scan_step).threshold, hard);
}

TEST(QuietRule, HasNoThresholdWhereEverySpeedIsQuiet) {
  Scene quiet = machine_with(0.1, 0.4);
  quiet.counting_limit = 10;
  const QuietRule rule = quiet_rule_of(quiet, scan_step);
  EXPECT_EQ(rule.threshold, std::nullopt);
  EXPECT_EQ(rule.limit, 0.5);
}

TEST(QuietRule, OfPeaksIsThatOfTheWindow) {
  Scene peaks = machine_with(0.9, 0.1);
  peaks.rule = CountRule::peaks;
  const QuietRule rule = quiet_rule_of(peaks, 1e-2);
  const Score found = score(peaks, Claim{}, ScanOptions{1e-2, 1});
  EXPECT_EQ(rule.limit, quiet_limit(found.quiet_count));
  EXPECT_EQ(rule.threshold, found.threshold);
}

}  // namespace
}  // namespace ricochet::carrier_track
