#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// The surrogate of a ball thrown up at x[0] [m/s] against 8 m/s^2, under a ceiling 1 m high that
/// it just reaches at 4 m/s, and of nothing else: the window ends before it is back.
struct Throw {
  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    BasicScene<Scalar> scene;
    scene.start_position = constant<Scalar>(0.0);
    scene.start_velocity = x[0];
    scene.pull = constant<Scalar>(8.0);
    scene.restitution_upper = constant<Scalar>(0.5);
    scene.counting_limit = constant<Scalar>(0.1);
    scene.window = Seconds{0.6};
    auto watcher = watch.of(scene);
    return objective(scene, default_smoothing, watcher);
  }
};

Trust trust_of_throw(double velocity) {
  return gradient_of<1>(Throw(), Vector::Constant(1, velocity), Vector::Constant(1, 10.0)).trust;
}

TEST(Trust, ReachesToWhereAThrowMeetsTheCeiling) {
  for (const double velocity : {3.0, 3.9, 3.999}) {
    // The distance that is missed, 1 - v^2 / 16, over its slope, in boxes of 10 m/s.
    const double expected = (1 - velocity * velocity / 16) / (velocity / 8) / 10;
    EXPECT_NEAR(trust_of_throw(velocity).reach, expected, 1e-12 * expected);
  }
}

TEST(Trust, ReachesToWhereAnImpactEnds) {
  for (const double velocity : {5.0, 4.1, 4.001}) {
    // The square of the approach speed, v^2 - 16, over its slope.
    const double expected = (velocity * velocity - 16) / (2 * velocity) / 10;
    EXPECT_NEAR(trust_of_throw(velocity).reach, expected, 1e-9 * expected);
  }
}

TEST(Trust, CallsAGradientFlatWhereNothingHits) {
  EXPECT_EQ(trust_of_throw(3.0).doubt, GradientDoubt::flat);
}

TEST(Trust, CallsAGradientNextToAGrazeAKink) {
  EXPECT_EQ(trust_of_throw(4.1).doubt, GradientDoubt::none);
  // So near that the reach is short, but the impact still weighs: 0.04 m/s.
  EXPECT_EQ(trust_of_throw(4.0002).doubt, GradientDoubt::kink);
}

TEST(Trust, CallsAGradientSensitiveWhereItsDigitsAreLost) {
  // A ball between two shaken walls, chaotic: a hundred impacts.
  Scene scene;
  scene.wall_upper = 1.0;
  scene.restitution_lower = scene.restitution_upper = 0.95;
  scene.centrifugal_mass_radius = 1.0;
  scene.omega = 3.0;
  scene.start_velocity = 0.3;
  scene.counting_limit = 1.0;
  scene.window = Seconds{3.0};
  EXPECT_EQ(surrogate_slope(scene, default_smoothing, 10.0).trust.doubt, GradientDoubt::none);
  scene.window = Seconds{200.0};
  EXPECT_EQ(surrogate_slope(scene, default_smoothing, 10.0).trust.doubt, GradientDoubt::sensitive);
}

/// The same throw at the sum of four variables.
struct SharedThrow {
  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const Scalar velocity = x[0] + x[1] + x[2] + x[3];
    return Throw()(std::span<const Scalar>(&velocity, 1), watch);
  }
};

TEST(Trust, IsTheSameInBlocksOfDirections) {
  const Vector x = Vector::Constant(4, 3.9 / 4);
  const Vector widths = Vector::Constant(4, 10.0);
  // Four slopes, each that of one variable: twice as steep together.
  const double whole = gradient_of<4>(SharedThrow(), x, widths).trust.reach;
  EXPECT_NEAR(whole, trust_of_throw(3.9).reach / 2, 1e-9);
  EXPECT_NEAR(gradient_of<1>(SharedThrow(), x, widths).trust.reach, whole, 1e-9);
  EXPECT_NEAR(gradient_of<5>(SharedThrow(), x, widths).trust.reach, whole, 1e-9);
}

/// How the motion is made: which walls are hit, in order, but for the tails of bounces [m/s] whose
/// number says nothing.
std::vector<Wall> structure_of(const Scene& scene) {
  std::vector<Wall> walls;
  for (const auto& hit : watch(scene).hits) {
    if (hit.speed > 1e-6) walls.push_back(hit.wall);
  }
  return walls;
}

/// Whether two motions are the same but for what comes in at the end of the window.
bool same(const std::vector<Wall>& a, const std::vector<Wall>& b) {
  const auto size = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
  return std::equal(a.begin(), a.begin() + size, b.begin());
}

TEST(Trust, ReachesToWhereTheMotionChanges) {
  RandomScenes draws(31);
  const auto cases = all_cases();
  int short_reaches = 0;
  int kept = 0;
  int changed = 0;
  for (int i = 0; i < 8000; ++i) {
    Scene scene = scene_of(cases[static_cast<std::size_t>(i) % cases.size()], exploratory_scene());
    scene.omega = draws.within(1.0, 17.0);
    const double reach = surrogate_slope(scene, default_smoothing, 1.0).trust.reach;
    if (reach > 5e-3) continue;
    ++short_reaches;
    const auto at = [&](double step) {
      Scene there = scene;
      there.omega += step * reach;
      return structure_of(there);
    };
    const auto here = structure_of(scene);
    kept += same(at(0.5), here) && same(at(-0.5), here);
    changed += !same(at(2.0), here) || !same(at(-2.0), here);
  }
  EXPECT_GT(short_reaches, 60);
  EXPECT_GT(kept, 0.85 * short_reaches);
  EXPECT_GT(changed, 0.6 * short_reaches);
  RecordProperty("of", short_reaches);
  RecordProperty("kept_within", kept);
  RecordProperty("changed_beyond", changed);
}

}  // namespace
}  // namespace ricochet::carrier_track
