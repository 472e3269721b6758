#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/counting/certainty.h"
#include "problems/carrier_track/motion/simulate.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

FeatureTrace trace_of(const Scene& scene) {
  FeatureTrace trace(scene);
  simulate(scene, trace);
  return trace;
}

/// A body that flies freely between walls 1 m apart: at 1 s it is on the upper, at 5 s on the
/// lower.
Scene slowing_body() {
  Scene scene;
  scene.start_velocity = 0.5;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.window = Seconds{10.0};
  scene.counting_limit = 0.4;
  return scene;
}

/// A body thrown up, which is highest at 0.5 s: 0.625 m.
Scene thrown_body() {
  Scene scene;
  scene.pull = 1.0;
  scene.start_velocity = 0.5;
  scene.window = Seconds{1.0};
  return scene;
}

TEST(FeatureTrace, KeepsImpactsByTheirWall) {
  const Scene scene = slowing_body();
  const FeatureTrace trace = trace_of(scene);
  const auto& upper = trace.features(FeatureTrace::upper_impact);
  ASSERT_EQ(upper.size(), 1U);
  EXPECT_DOUBLE_EQ(upper[0].time, 1.0);
  EXPECT_DOUBLE_EQ(upper[0].margin(), std::log(0.5 / 0.4));
  EXPECT_EQ(upper[0].scaled, upper[0].margin());
  const auto& lower = trace.features(FeatureTrace::lower_impact);
  ASSERT_EQ(lower.size(), 1U);
  EXPECT_DOUBLE_EQ(lower[0].time, 5.0);
  EXPECT_DOUBLE_EQ(lower[0].margin(), std::log(0.25 / 0.4));
  EXPECT_DOUBLE_EQ(lower[0].scaled, 0.25 / 0.4 - 1);  // too slow to count
  EXPECT_EQ(trace.impacts(Wall::upper).size(), 1U);
  EXPECT_EQ(trace.impacts(Wall::lower).size(), 1U);
  EXPECT_TRUE(trace.features(FeatureTrace::high_peak).empty());
  EXPECT_FALSE(trace.graze());
}

TEST(FeatureTrace, KeepsEveryMaximumWithBothItsMargins) {
  Scene scene = thrown_body();
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.5;
  scene.peak_low = 0.5;
  const FeatureTrace trace = trace_of(scene);
  const auto& high = trace.features(FeatureTrace::high_peak);
  ASSERT_EQ(high.size(), 1U);
  EXPECT_NEAR(high[0].time, 0.5, 1e-12);
  EXPECT_NEAR(high[0].margin(), 0.25, 1e-12);
  const auto& low = trace.features(FeatureTrace::low_peak);
  ASSERT_EQ(low.size(), 1U);
  EXPECT_NEAR(low[0].margin(), -0.25, 1e-12);
  EXPECT_NEAR(low[0].scaled, std::exp(-0.25) - 1, 1e-12);
  EXPECT_TRUE(trace.features(FeatureTrace::upper_impact).empty());
}

TEST(FeatureTrace, TellsOfMaximaWithoutAnEnd) {
  Scene scene = thrown_body();
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.5;
  scene.peak_low = 1e-3;
  scene.restitution_lower = 0.5;
  scene.window = Seconds{10.0};
  scene.across.emplace();
  // Down from 0.625 m, and up again at half the speed, each time. They end after three falls.
  const double fall = std::sqrt(2 * 0.625);
  for (const Fidelity level : {Fidelity::impact, Fidelity::planar}) {
    scene.fidelity = level;
    const FeatureTrace trace = trace_of(scene);
    ASSERT_TRUE(trace.endless());
    EXPECT_NEAR(trace.endless()->time, 0.5 + 3 * fall, 1e-8);
    EXPECT_EQ(trace.endless()->wall, Wall::lower);
  }
  // None of them counts where the wall lies between the limits, or the body stays on it.
  Scene between = scene;
  between.wall_lower = 0.125;
  EXPECT_FALSE(trace_of(between).endless());
  Scene plastic = scene;
  plastic.restitution_lower = 0;
  EXPECT_FALSE(trace_of(plastic).endless());
  scene.window = Seconds{0.5 + fall};
  EXPECT_FALSE(trace_of(scene).endless()) << "there is an end before";
  // The other way up the maxima lie on the wall itself, which is high.
  Scene above = thrown_body();
  above.rule = CountRule::peaks;
  above.pull = -1.0;
  above.start_velocity = 0.0;
  above.restitution_upper = 0.5;
  above.window = Seconds{10.0};
  EXPECT_TRUE(trace_of(above).endless());
}

TEST(FeatureTrace, TellsOfSwingsInAWallWithoutAnEnd) {
  Scene scene = thrown_body();
  scene.rule = CountRule::peaks;
  scene.peak_high = 0.5;
  scene.peak_low = 1e-3;
  scene.restitution_lower = 0.5;
  scene.fidelity = Fidelity::compliant;
  scene.stiffness = 1e4;
  scene.window = Seconds{10.0};
  EXPECT_TRUE(trace_of(scene).endless());
  scene.window = Seconds{1.0};  // before it comes down
  EXPECT_FALSE(trace_of(scene).endless());
}

TEST(FeatureTrace, KnowsAMaximumThatRoundingMakes) {
  // From rest by x'' = sin t: the speed 1 - cos t touches zero at every turn, and is never below.
  Scene scene;
  scene.wall_upper = 100.0;
  scene.rule = CountRule::peaks;
  scene.centrifugal_mass_radius = 1.0;
  scene.start_position = 0.0;
  scene.window = Seconds{30.0};
  int told = 0;
  for (int i = 0; i < 20; ++i) {
    scene.phase = -std::numbers::pi / 2 - 0.1 * i;  // it is released when the force has turned
    const FeatureTrace trace = trace_of(scene);
    const bool one = !trace.features(FeatureTrace::high_peak).empty();
    EXPECT_EQ(trace.shallow_peak().has_value(), one);
    told += one ? 1 : 0;
  }
  EXPECT_GT(told, 0) << "none to doubt";
  EXPECT_FALSE(trace_of(thrown_body()).shallow_peak());
}

TEST(FeatureTrace, KnowsWhatIsNoNumber) {
  const Scene scene = thrown_body();
  FeatureTrace trace(scene);
  trace.impact(0.25, Wall::lower, 1.0);
  EXPECT_TRUE(trace.finite());
  trace.impact(0.5, Wall::lower, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(trace.finite());
}

TEST(FeatureTrace, TellsTheNearestWallMissed) {
  Scene scene = thrown_body();
  scene.wall_upper = 0.75;
  const FeatureTrace missed = trace_of(scene);
  ASSERT_TRUE(missed.graze());
  EXPECT_EQ(missed.graze()->wall, Wall::upper);
  EXPECT_NEAR(missed.graze()->time, 0.5, 1e-12);
  EXPECT_NEAR(missed.graze()->distance, 0.125, 1e-12);
  scene.wall_upper = 0.6;
  const FeatureTrace hit = trace_of(scene);
  EXPECT_EQ(hit.impacts(Wall::upper).size(), 1U);
  EXPECT_FALSE(hit.graze());
}

}  // namespace
}  // namespace ricochet::carrier_track
