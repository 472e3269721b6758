#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

#include "src/studies/paper/theory.h"
#include "tests/carrier_track/models/watch.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;
constexpr double omega = 30.0;
constexpr double turn = 2 * pi / omega;

struct Surface {
  double restitution, friction;  ///< friction force over pull
};

const Surface surfaces[] = {{0.1, 0.0}, {0.1, 0.2}, {0.1, 0.8}, {0.3, 0.5}, {0.6, 0.0},
                            {0.6, 0.3}, {0.9, 0.0}, {0.9, 0.2}, {0.9, 0.8}};

/// Leaves the lower, only wall at angle and speed of the limit, with `strength` times its drive.
Scene at_limit(const Surface& surface, double strength, double turns) {
  Scene scene;
  scene.mass = 2.0;
  scene.pull = 3.0;
  scene.normal_force = 1.5;
  scene.friction = surface.friction * scene.pull / scene.normal_force;
  scene.restitution_lower = surface.restitution;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  const SustainedBouncing limit =
      sustained_bouncing(3.0, surface.friction * 3.0, surface.restitution).value();
  scene.omega = omega;
  scene.centrifugal_mass_radius = strength * limit.force / (omega * omega);
  scene.phase = limit.departure_angle;
  scene.start_position = 0.0;
  scene.start_velocity = limit.departure_speed / (scene.mass * omega);
  scene.window = Revolutions{turns};
  return scene;
}

/// The speed [rad/s] from which the drive lifts a body that rests on the wall.
double lift_off_speed(const Scene& scene) {
  return std::sqrt((scene.pull + scene.friction * scene.normal_force) /
                   scene.centrifugal_mass_radius);
}

/// Whether in the last hundred turns of the window the body strikes once a turn, always equally
/// fast, and in between rises and falls once, without a halt.
bool bounces_once_a_turn(const Scene& scene) {
  const auto watched = watch(scene);
  const auto is_late = [&](const auto& it) { return it.time > watched.end.time - 100 * turn; };
  std::vector<Watched<double>::Hit> late;
  std::copy_if(watched.hits.begin(), watched.hits.end(), std::back_inserter(late), is_late);
  if (late.size() < 99 || late.size() > 101) return false;
  for (std::size_t k = 1; k < late.size(); ++k) {
    if (std::abs(late[k].time - late[k - 1].time - turn) > 1e-6 * turn) return false;
    if (std::abs(late[k].speed / late[0].speed - 1) > 1e-6) return false;
  }
  return std::count_if(watched.stretches.begin(), watched.stretches.end(), is_late) <= 202;
}

TEST(SustainedBouncing, NeedsTheClosedFormulationDriveWithoutFriction) {
  for (const double e : {0.1, 0.5, 0.9, 0.999}) {
    const auto limit = sustained_bouncing(0.7, 0.0, e);
    ASSERT_TRUE(limit) << e;
    EXPECT_NEAR(limit->force, pi * 0.7 * (1 - e) / (1 + e), 1e-14) << e;
    EXPECT_NEAR(limit->departure_speed, 2 * pi * 0.7 * e / (1 + e), 1e-14) << e;
    EXPECT_NEAR(limit->departure_angle, -pi / 2, 1e-9) << e;
  }
}

TEST(SustainedBouncing, ComesBackAfterExactlyOneTurn) {
  for (const Surface& surface : surfaces) {
    const Scene scene = at_limit(surface, 1.0, 1.5);
    const auto watched = watch(scene);
    ASSERT_GE(watched.hits.size(), 1U);
    ASSERT_GE(watched.tops.size(), 1U);
    const double e = surface.restitution;
    const auto limit = sustained_bouncing(3.0, surface.friction * 3.0, e);
    EXPECT_NEAR(watched.hits[0].time, turn, 1e-11 * turn) << e << " " << surface.friction;
    EXPECT_NEAR(watched.hits[0].speed * e, scene.start_velocity, 1e-11) << e << surface.friction;
    EXPECT_NEAR(watched.tops[0].time * omega, limit->turning_angle, 1e-10);
    EXPECT_NEAR(watched.tops[0].position * 2 * omega * omega, limit->height, 1e-10);
  }
}

TEST(SustainedBouncing, LastsJustAboveTheLimitAndDiesJustBelow) {
  for (const Surface& surface : surfaces) {
    EXPECT_TRUE(bounces_once_a_turn(at_limit(surface, 1.0005, 3000)))
        << surface.restitution << " " << surface.friction;
    EXPECT_FALSE(bounces_once_a_turn(at_limit(surface, 0.9995, 3000)))
        << surface.restitution << " " << surface.friction;
  }
}

TEST(SustainedBouncing, GivesWayToStartingAnewEveryTurnWhereTheDriveLiftsABodyAtRest) {
  const Surface surface{0.1, 0.2};
  const Scene scene = at_limit(surface, 0.9, 300);
  ASSERT_GT(omega, lift_off_speed(scene));
  const auto watched = watch(scene);
  EXPECT_GE(watched.hits.size(), 300U);
  EXPECT_GT(watched.hits.back().time, 298 * turn);
}

TEST(SustainedBouncing, LeavesABodyAtRestWhereTheDriveDoesNotLiftIt) {
  int at_rest = 0;
  for (const Surface& surface : surfaces) {
    const Scene scene = at_limit(surface, 0.9995, 3000);
    if (omega < 0.999 * lift_off_speed(scene)) {
      const auto watched = watch(scene);
      EXPECT_LT(watched.hits.back().time, 2900 * turn);
      EXPECT_EQ(watched.end.position, 0.0);
      ++at_rest;
    }
  }
  EXPECT_GE(at_rest, 4);
}

TEST(SustainedBouncing, GrowsWithFrictionAsItsDerivativeSays) {
  for (const double e : {0.1, 0.5, 0.9}) {
    // The turning angle without friction, then the explicit part of the derivative.
    const double strength = pi * (1 - e) / (1 + e);
    double t = 1.3 * pi;
    for (int i = 0; i < 50; ++i) {
      const double v = 2 * pi * e / (1 + e) - t + strength * (1 - std::cos(t));
      t -= v / (-1 + strength * std::sin(t));
    }
    const double slope = 2 * (pi - t) * e / (1 + e) + 2 * t - t * t / (2 * pi) - pi;
    const double h = 1e-5;
    const double risen = sustained_bouncing(1.0, h, e)->force - strength;
    EXPECT_NEAR(risen / h, slope, 1e-3 * slope) << e;
  }
}

TEST(SustainedBouncing, NeedsTheWorkOfFrictionOnAnElasticWall) {
  // In a hop of height pi^2/2 pull/(mass omega^2) friction takes pi^2 F of these, and the drive at
  // its best angle gives 2 pi A.
  for (const double friction : {0.2, 0.7}) {
    EXPECT_NEAR(sustained_bouncing(1.0, friction, 1 - 1e-9)->force, pi / 2 * friction, 1e-6);
  }
}

TEST(SustainedBouncing, SaysNothingWhereItsAssumptionsFail) {
  EXPECT_FALSE(sustained_bouncing(1.0, 1.0, 0.5));
  EXPECT_FALSE(sustained_bouncing(1.0, -0.1, 0.5));
  EXPECT_FALSE(sustained_bouncing(0.0, 0.0, 0.5));
  EXPECT_FALSE(sustained_bouncing(1.0, 0.0, 0.0));
  EXPECT_FALSE(sustained_bouncing(1.0, 0.0, 1.0));
  EXPECT_FALSE(sustained_bouncing(1.0, 0.0, 0.02));
  EXPECT_TRUE(sustained_bouncing(1.0, 0.0, 0.04));
}

TEST(SustainedBouncing, GivesTheSpeedOfAScene) {
  Scene scene;
  scene.mass = 1.5;
  scene.pull = 2.0;
  scene.restitution_lower = 0.5;
  scene.centrifugal_mass_radius = 0.3;
  scene.slider_mass_radius = 0.1;
  EXPECT_NEAR(sustained_bouncing_speed(scene).value(), std::sqrt(2 * pi / 3 / 0.2), 1e-12);
  scene.friction = 0.1;
  scene.normal_force = 4.0;
  const double speed = sustained_bouncing_speed(scene).value();
  EXPECT_NEAR(0.2 * speed * speed, sustained_bouncing(2.0, 0.4, 0.5)->force, 1e-12);

  const SustainedBouncing limit = sustained_bouncing(scene).value();
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.phase = limit.departure_angle;
  scene.omega = speed;
  scene.start_position = 0;
  scene.start_velocity = limit.departure_speed / (scene.mass * speed);
  scene.window = Revolutions{0.9};
  EXPECT_NEAR(watch(scene).tops.at(0).position, limit.height / (scene.mass * speed * speed), 1e-12);
}

TEST(SustainedBouncing, HasNoSpeedForASceneOfOtherForces) {
  Scene scene;
  scene.pull = 2.0;
  scene.restitution_lower = 0.5;
  EXPECT_FALSE(sustained_bouncing_speed(scene)) << "no drive";
  scene.centrifugal_mass_radius = 0.3;
  EXPECT_TRUE(sustained_bouncing_speed(scene));
  Scene other = scene;
  other.pull_rotates = true;
  EXPECT_FALSE(sustained_bouncing_speed(other));
  other = scene;
  other.centrifugal = Centrifugal::inward;
  EXPECT_FALSE(sustained_bouncing_speed(other));
  other = scene;
  other.friction = 1.0;
  other.normal_force = 2.0;
  EXPECT_FALSE(sustained_bouncing_speed(other)) << "friction holds the body";
}

}  // namespace
}  // namespace ricochet::carrier_track
