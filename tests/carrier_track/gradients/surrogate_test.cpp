#include <ceres/jet.h>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/difference.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// For other scenes and constants see derivatives_test.cpp.
TEST(Surrogate, HasASlopeForABodyThatStartsAtRestAtAWall) {
  for (const Case& a_case : all_cases()) {
    const Scene from_case = at_speed(scene_of(a_case, exploratory_scene()), 7.0);
    for (const double wall : {from_case.wall_lower, from_case.wall_upper}) {
      const Scene scene = with(from_case, set::start(wall, 0));
      const Slope exact = surrogate_slope(scene, default_smoothing);
      expect_close(exact.value, objective(scene, default_smoothing), 1e-9);
      const auto value_at = [&](double omega) {
        return objective(at_speed(scene, omega), default_smoothing);
      };
      expect_close(exact.slope, difference(value_at, scene.omega, 1e-3).slope, 1e-7);
    }
  }
}

TEST(Surrogate, HasASlopeWhereAnImpactOnlyTouches) {
  // Thrown up with the apex at the wall: some touch it at next to 0 m/s, where dt/dx is infinite.
  int touches = 0;
  for (double velocity = 0.5; velocity < 10; velocity += 0.5) {
    for (double gravity = 0.5; gravity < 10; gravity += 0.5) {
      const Scene scene = with(Scene{}, set::start(0, velocity), set::pull(gravity),
                               set::wall_upper(velocity * velocity / (2 * gravity)),
                               set::restitution_lower(0.5), set::seconds(5));
      auto dual = lifted<ceres::Jet<double, 1>>(scene);
      dual.start_velocity.v[0] = 1.0;
      EXPECT_TRUE(std::isfinite(objective(dual, default_smoothing).v[0]))
          << velocity << " " << gravity;
      for (const auto& hit : watch(scene).hits) touches += hit.speed < 1e-9;
    }
  }
  EXPECT_GT(touches, 0);
}

/// The surrogate of a ball thrown up at the sum of x [m/s] against 8 m/s^2, under a ceiling 1 m
/// high that it just reaches at 4 m/s, and of nothing else: the window ends before it is back.
struct Throw {
  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    BasicScene<Scalar> scene;
    scene.start_position = constant<Scalar>(0.0);
    for (const Scalar& share : x) scene.start_velocity += share;
    scene.pull = constant<Scalar>(8.0);
    scene.restitution_upper = constant<Scalar>(0.5);
    scene.counting_limit = constant<Scalar>(0.1);
    scene.window = Seconds{0.6};
    auto watcher = watch.of(scene);
    return objective(scene, default_smoothing, watcher);
  }
};

template <int block = 1>
Trust trust_of_throw(double velocity, Eigen::Index parts = 1) {
  return gradient_of<block>(Throw(), Vector::Constant(parts, velocity / static_cast<double>(parts)),
                            Vector::Constant(parts, 10.0))
      .trust;
}

TEST(Trust, ReachesToWhereAThrowMeetsTheCeilingOrAnImpactEnds) {
  // The distance that is missed, 1 - v^2 / 16, over its slope, in boxes of 10 m/s.
  for (const double v : {3.0, 3.9, 3.999}) {
    expect_close(trust_of_throw(v).reach, (1 - v * v / 16) / (v / 8) / 10);
  }
  // The square of the approach speed, v^2 - 16, over its slope.
  for (const double v : {5.0, 4.1, 4.001}) {
    expect_close(trust_of_throw(v).reach, (v * v - 16) / (2 * v) / 10, 1e-9);
  }
}

TEST(Trust, CallsAGradientNextToAGrazeAKinkAndFlatWhereNothingHits) {
  EXPECT_EQ(trust_of_throw(3.0).doubt, GradientDoubt::flat);
  EXPECT_EQ(trust_of_throw(4.1).doubt, GradientDoubt::none);
  // So near that the reach is short, but the impact still weighs: 0.04 m/s.
  EXPECT_EQ(trust_of_throw(4.0002).doubt, GradientDoubt::kink);
}

TEST(Trust, CallsAGradientSensitiveWhereItsDigitsAreLost) {
  // A ball between two shaken walls, chaotic: a hundred impacts.
  const auto doubt_after = [](double seconds) {
    const Scene scene =
        with(Scene{}, set::restitution(0.95), set::centrifugal_mass_radius(1), set::omega(3),
             set::start_velocity(0.3), set::counting_limit(1), set::seconds(seconds));
    return surrogate_slope(scene, default_smoothing, 10.0).trust.doubt;
  };
  EXPECT_EQ(doubt_after(3), GradientDoubt::none);
  EXPECT_EQ(doubt_after(200), GradientDoubt::sensitive);
}

TEST(Trust, IsTheSameInBlocksOfDirections) {
  // Four slopes, each that of one variable: twice as steep together.
  for (const Trust& trust :
       {trust_of_throw<1>(3.9, 4), trust_of_throw<4>(3.9, 4), trust_of_throw<5>(3.9, 4)}) {
    EXPECT_NEAR(trust.reach, trust_of_throw(3.9).reach / 2, 1e-9);
  }
}

TEST(Trust, ReachesToWhereTheMotionChanges) {
  RandomScenes draws(31);
  const auto cases = all_cases();
  int short_reaches = 0, kept = 0, changed = 0;
  for (int i = 0; i < 8000; ++i) {
    const Scene scene =
        at_speed(scene_of(cases[static_cast<std::size_t>(i) % cases.size()], exploratory_scene()),
                 draws.within(1.0, 17.0));
    const double reach = surrogate_slope(scene, default_smoothing, 1.0).trust.reach;
    if (reach > 5e-3) continue;
    ++short_reaches;
    const auto here = distinct(watch(scene).hits);
    // Whether the same walls are hit in the same order, but for what comes in at the end.
    const auto same_at = [&](double step) {
      const auto there = distinct(watch(at_speed(scene, scene.omega + step * reach)).hits);
      const auto size = static_cast<std::ptrdiff_t>(std::min(there.size(), here.size()));
      return std::equal(there.begin(), there.begin() + size, here.begin(),
                        [](const auto& a, const auto& b) { return a.wall == b.wall; });
    };
    kept += same_at(0.5) && same_at(-0.5);
    changed += !same_at(2.0) || !same_at(-2.0);
  }
  EXPECT_GT(short_reaches, 60);
  EXPECT_GT(kept, 0.85 * short_reaches);
  EXPECT_GT(changed, 0.6 * short_reaches);
}

}  // namespace
}  // namespace ricochet::carrier_track
