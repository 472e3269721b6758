#include <ceres/jet.h>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "src/core/difference.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// How far the surrogate's slope is from that of differences of this step [rad/s], relative to it.
double error_of_slope(const Scene& scene, double step) {
  const Slope exact = surrogate_slope(scene, default_smoothing);
  EXPECT_NEAR(exact.value, objective(scene, default_smoothing), 1e-9 * exact.value);
  const auto value_at = [&](double omega) {
    return objective(at_speed(scene, omega), default_smoothing);
  };
  return std::abs(exact.slope / difference(value_at, scene.omega, step).slope - 1);
}

TEST(Surrogate, HasTheSlopeOfDifferencesAtAThousandRandomSpeeds) {
  RandomScenes draws(5);
  std::vector<double> errors;
  const auto cases = all_cases();
  for (std::size_t i = 0; i < 1000; ++i) {
    const double omega = draws.within(0.5, 18.0);
    errors.push_back(error_of_slope(
        at_speed(scene_of(cases[i % cases.size()], exploratory_scene()), omega), 1e-3 * omega));
  }
  EXPECT_LT(quantile(errors, 0.5), 1e-10);
  EXPECT_LT(quantile(errors, 0.99), 1e-7);
}

TEST(Surrogate, HasTheSlopeOfDifferencesUnderTheRuleOfPeaks) {
  RandomScenes draws(6);
  std::vector<double> errors;
  for (int i = 0; i < 100; ++i) {
    const double omega = draws.within(1.0, 18.0);
    errors.push_back(
        error_of_slope(with(scene_of(find_case(i % 2 == 0 ? "C2" : "C9"), exploratory_scene()),
                            set::rule(CountRule::peaks), set::peak_high(0.8e-3),
                            set::peak_low(0.2e-3), set::seconds(0.3), set::omega(omega)),
                       1e-5 * omega));
  }
  EXPECT_LT(quantile(errors, 0.5), 1e-7);
  EXPECT_LT(quantile(errors, 0.9), 1e-5);
}

TEST(Surrogate, HasASlopeForABodyThatStartsAtRestAtAWall) {
  for (const Case& a_case : all_cases()) {
    const Scene scene = at_speed(scene_of(a_case, exploratory_scene()), 7.0);
    for (const double wall : {scene.wall_lower, scene.wall_upper}) {
      EXPECT_LT(error_of_slope(with(scene, set::start(wall, 0)), 1e-3), 1e-7) << a_case.id;
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
  for (const double velocity : {3.0, 3.9, 3.999}) {
    // The distance that is missed, 1 - v^2 / 16, over its slope, in boxes of 10 m/s.
    const double expected = (1 - velocity * velocity / 16) / (velocity / 8) / 10;
    expect_close(trust_of_throw(velocity).reach, expected);
  }
  for (const double velocity : {5.0, 4.1, 4.001}) {
    // The square of the approach speed, v^2 - 16, over its slope.
    const double expected = (velocity * velocity - 16) / (2 * velocity) / 10;
    expect_close(trust_of_throw(velocity).reach, expected, 1e-9);
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
  const double expected = trust_of_throw(3.9).reach / 2;
  EXPECT_NEAR(trust_of_throw<1>(3.9, 4).reach, expected, 1e-9);
  EXPECT_NEAR(trust_of_throw<4>(3.9, 4).reach, expected, 1e-9);
  EXPECT_NEAR(trust_of_throw<5>(3.9, 4).reach, expected, 1e-9);
}

TEST(Trust, ReachesToWhereTheMotionChanges) {
  RandomScenes draws(31);
  const auto cases = all_cases();
  int short_reaches = 0;
  int kept = 0;
  int changed = 0;
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
