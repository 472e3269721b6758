#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/expect_close.h"
#include "tests/carrier_track/models/watch.h"

/// Orbits with closed forms, for a body seen from walls that shake as A sin(omega t): in their
/// frame x'' = ... + A omega^2 sin(omega t), and the walls stand still.
namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;
constexpr double shaking = 30.0;

/// Walls shaken with amplitude [m] that stand at `angle` when the body starts.
Scene shaken(double amplitude, double angle, double restitution) {
  Scene scene;
  scene.mass = 2.0;
  scene.omega = shaking;
  scene.centrifugal_mass_radius = scene.mass * amplitude;
  scene.phase = angle - pi / 2;
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.start_position = 0.0;
  return scene;
}

/// Jacobian of (angle, speed of departure) at the next impact with respect to the same now, by
/// duals. The sign of the start velocity is that of the departure.
Eigen::Matrix2d return_map(const Scene& scene) {
  using Jet = ceres::Jet<double, 2>;
  auto dual = lifted<Jet>(scene);
  dual.phase.v[0] = 1.0;
  dual.start_velocity.v[1] = scene.start_velocity > 0 ? 1.0 : -1.0;
  const auto watched = watch(dual);
  const auto& hit = watched.hits.at(0);
  const Jet angle = dual.phase + dual.omega * hit.time;
  const Jet speed = dual.restitution_lower * hit.speed;
  Eigen::Matrix2d map;
  map << angle.v.transpose(), speed.v.transpose();
  return map;
}

double spectral_radius(const Eigen::Matrix2d& map) {
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

constexpr double gravity = 9.81;

/// A ball on a table of peak acceleration `strength` gravity, on the orbit that strikes every
/// n-th period.
Scene on_table(double strength, double e, int n) {
  const double cosine = n * pi * (1 - e) / ((1 + e) * strength);
  Scene scene = shaken(strength * gravity / (shaking * shaking), std::acos(cosine), e);
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.pull = scene.mass * gravity;
  scene.start_velocity = e / (1 + e) * gravity * 2 * pi * n / shaking;
  scene.window = Seconds{1.5 * 2 * pi * n / shaking};
  return scene;
}

double doubling_strength(double e, int n) {
  return std::hypot(n * pi * (1 - e) / (1 + e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
}

TEST(PeriodicOrbit, ABallOnAShakenTableStrikesOncePerPeriod) {
  for (const double e : {0.2, 0.5, 0.8}) {
    for (const int n : {1, 2, 3}) {
      const Scene scene = on_table(doubling_strength(e, n) * 0.99, e, n);
      const auto watched = watch(scene);
      expect_close(watched.hits.at(0).time, 2 * pi * n / shaking);
      expect_close(watched.hits.at(0).speed, gravity * 2 * pi * n / shaking / (1 + e));
    }
  }
}

TEST(PeriodicOrbit, TheBallOnATableDoublesItsPeriodAtTheClosedFormStrength) {
  EXPECT_NEAR(doubling_strength(0.5, 1), 1.526823700519,
              5e-13);  // by another program, in extended precision
  for (const double e : {0.2, 0.5, 0.8}) {
    for (const int n : {1, 2}) {
      const double strength = doubling_strength(e, n);
      // At the boundary an eigenvalue is -1: 1 + trace + determinant = 0.
      const Eigen::Matrix2d map = return_map(on_table(strength, e, n));
      EXPECT_NEAR(1 + map.trace() + map.determinant(), 0.0, 1e-11);
      EXPECT_NEAR(map.determinant(), e * e, 1e-11);
      EXPECT_LT(spectral_radius(return_map(on_table(strength * 0.999, e, n))), 1.0);
      EXPECT_GT(spectral_radius(return_map(on_table(strength * 1.001, e, n))), 1.0);
    }
  }
}

TEST(PeriodicOrbit, TheBallOnATableSettlesBelowTheBoundaryAndAlternatesAboveIt) {
  for (const bool above : {false, true}) {
    const double strength = doubling_strength(0.5, 1) * (above ? 1.01 : 0.99);
    Scene scene = on_table(strength, 0.5, 1);
    const double speed = gravity * 2 * pi / shaking / 1.5;
    scene.start_velocity *= 1.001;
    scene.window = Revolutions{2000};
    const auto watched = watch(scene);
    const std::size_t last = watched.hits.size() - 1;
    ASSERT_GE(last, 1990U);
    const double change = watched.hits[last].speed - watched.hits[last - 1].speed;
    EXPECT_NEAR(watched.hits[last].speed, watched.hits[last - 2].speed, 1e-9);
    if (above) {
      EXPECT_GT(std::abs(change), 0.01 * speed);
    } else {
      EXPECT_LT(std::abs(change), 1e-9 * speed);
      expect_close(watched.hits[last].speed, speed, 1e-9);
      const double turns = watched.hits[last].time * shaking / (2 * pi);
      EXPECT_NEAR(turns, std::round(turns), 1e-9);
    }
  }
}

/// A free body between two shaken walls, a gap of `ratio` amplitudes apart, leaving the upper wall
/// on the symmetric orbit of the greater speed.
Scene between_walls(double ratio, double e) {
  const double amplitude = 0.01;
  const double gap = ratio * amplitude;
  const double rho = (1 - e) / (1 + e);
  // (u pi/w - d)^2 / 4 + (rho u/w)^2 = A^2 as a quadratic in u/w.
  const double a = pi * pi / 4 + rho * rho;
  const double b = pi * gap / 4;
  const double c = gap * gap / 4 - amplitude * amplitude;
  const double u = shaking * (b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  const double angle = std::atan2((u * pi / shaking - gap) / 2, -rho * u / shaking);
  Scene scene = shaken(amplitude, angle, e);
  scene.wall_upper = gap;
  scene.start_position = gap;
  scene.start_velocity = -e * u * (1 + rho);
  scene.window = Revolutions{0.75};
  return scene;
}

double lowest_ratio(double rho) {
  return (pi * pi - 4) / std::sqrt(4 + pi * pi * rho * rho);
}

double highest_ratio(double rho) {
  return std::sqrt(pi * pi + 4 * rho * rho) / rho;
}

TEST(PeriodicOrbit, ABodyBetweenShakenWallsStrikesOncePerHalfPeriod) {
  for (const double e : {0.3, 0.5, 0.9}) {
    for (const double ratio : {3.0, 4.0, 6.0}) {
      const Scene scene = between_walls(ratio, e);
      const auto watched = watch(scene);
      ASSERT_GE(watched.hits.size(), 1U);
      EXPECT_EQ(watched.hits[0].wall, Wall::lower);
      expect_close(watched.hits[0].time, pi / shaking);
      expect_close(watched.hits[0].speed, -scene.start_velocity / e);
    }
  }
}

TEST(PeriodicOrbit, TheOrbitBetweenShakenWallsIsStableBetweenItsClosedFormBounds) {
  const double third = (1 - 0.5) / (1 + 0.5);
  EXPECT_NEAR(lowest_ratio(third), 2.5999655236,
              5e-11);  // by another program, in extended precision
  EXPECT_NEAR(highest_ratio(third), 9.6346478716, 5e-11);
  for (const double e : {0.3, 0.5, 0.8}) {
    const double rho = (1 - e) / (1 + e);
    const double low = lowest_ratio(rho);
    const double high = highest_ratio(rho);
    // Half a period and a mirror make the map; its eigenvalues leave the unit circle at -1 and +1.
    const Eigen::Matrix2d lowest = return_map(between_walls(low, e));
    EXPECT_NEAR(1 + lowest.trace() + lowest.determinant(), 0.0, 1e-10);
    const Eigen::Matrix2d highest = return_map(between_walls(high, e));
    EXPECT_NEAR(1 - highest.trace() + highest.determinant(), 0.0, 1e-6);
    for (const double ratio : {low * 1.001, (low + high) / 2, high * 0.999}) {
      EXPECT_LT(spectral_radius(return_map(between_walls(ratio, e))), 1.0) << ratio;
    }
    EXPECT_GT(spectral_radius(return_map(between_walls(low * 0.999, e))), 1.0);
  }
}

TEST(PeriodicOrbit, AnImpactMapsDisturbancesByTheSaltationMatrix) {
  using Jet = ceres::Jet<double, 2>;
  for (const double mu : {0.0, 0.2}) {
    Scene scene;
    scene.mass = 1.3;
    scene.pull = 2.0;
    scene.friction = mu;
    scene.normal_force = 3.0;
    scene.disturbance = 0.7;
    scene.disturbance_frequency = 5.0;
    scene.restitution_lower = 0.6;
    scene.start_position = 0.3;
    scene.start_velocity = -1.0;
    scene.window = Seconds{0.3};
    auto dual = lifted<Jet>(scene);
    dual.start_position.v[0] = 1.0;
    dual.start_velocity.v[1] = 1.0;
    const auto watched = watch(dual);
    ASSERT_EQ(watched.hits.size(), 1U);
    ASSERT_EQ(watched.stretches.size(), 2U) << "no turning point";
    const double t = watched.hits[0].time.a;
    const double v = -watched.hits[0].speed.a;
    const double force = -2.0 + 0.7 * std::cos(5.0 * t);
    const double before = (force + mu * 3.0) / 1.3;
    const double after = (force - mu * 3.0) / 1.3;
    Eigen::Matrix2d saltation;
    saltation << -0.6, 0, (after + 0.6 * before) / v, -0.6;
    Eigen::Matrix2d there;
    there << 1, t, 0, 1;
    Eigen::Matrix2d back;
    back << 1, 0.3 - t, 0, 1;
    const Eigen::Matrix2d expected = back * saltation * there;
    Eigen::Matrix2d actual;
    actual << watched.end.position.v.transpose(), watched.end.velocity.v.transpose();
    EXPECT_LT((actual - expected).norm(), 1e-13 * expected.norm());
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
