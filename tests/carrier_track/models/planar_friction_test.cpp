#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/planar_brute_force.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

using Hit = Watched<double>::Hit;

/// Far from the walls of x, pressed to the upper wall of y for good, under a slider force that acts
/// on both.
Scene pressed_by_a_turning_force() {
  Scene scene;
  scene.fidelity = Fidelity::planar;
  scene.mass = 0.8;
  scene.wall_lower = -100;
  scene.wall_upper = infinity;
  scene.start_position = 0;
  scene.friction = 0.3;
  scene.normal_force = 0.2;
  scene.omega = 3;
  scene.slider_mass_radius = 0.1;
  scene.across = Across<double>{};
  scene.across->start_position = 1;
  scene.across->pull = 1.5;
  return scene;
}

TEST(PlanarFriction, AVaryingPressSlowsASlidingBodyAsAnIntegratorHasIt) {
  using State = std::array<double, 2>;
  namespace odeint = boost::numeric::odeint;
  RandomScenes draws(54);
  for (int i = 0; i < 100; ++i) {
    Scene scene = pressed_by_a_turning_force();
    scene.omega = draws.within(1, 20);
    scene.slider_mass_radius = draws.within(0.2, 1.4) / (scene.omega * scene.omega);
    scene.friction = draws.within(0.1, 0.6);
    scene.phase = draws.within(-3, 3);
    scene.disturbance = draws.within(-1, 1);
    scene.disturbance_frequency = draws.within(1, 30);
    // Faster than all forces could stop it in the window.
    const double sigma = draws.chance(0.5) ? 1 : -1;
    scene.start_velocity = sigma * 5;
    scene.window = Seconds{0.5};
    const auto motion = [&](const State& x, State& slope, double time) {
      const double press = applied_force_across(scene, time);
      const double friction = scene.friction * (scene.normal_force + press);
      slope = {x[1], (force_of_plate(scene, time) - sigma * friction) / scene.mass};
    };
    State state = {0, scene.start_velocity};
    odeint::integrate_adaptive(
        odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_dopri5<State>()), motion, state,
        0.0, 0.5, 1e-3);
    const auto watched = watch(scene);
    EXPECT_NEAR(watched.end.position, state[0], 1e-11);
    EXPECT_NEAR(watched.end.velocity, state[1], 1e-11);
    EXPECT_EQ(watched.stretches.size(), 1U);
  }
}

TEST(PlanarFriction, ABodyHeldByAVaryingPressSlipsWhereTheForceLeavesItsBand) {
  // With S = slider_mass_radius omega^2, the force is -S cos a, the press P + S sin a. It slips up
  // where -S (cos a + mu sin a) = mu (N + P), down where -S (cos a - mu sin a) = -mu (N + P).
  Scene scene = pressed_by_a_turning_force();
  const double mu = scene.friction;
  const double limit = mu * (0.2 + 1.5) / (0.9 * std::hypot(1, mu));
  const double up = std::acos(-limit) + std::atan(mu);
  const double down = 2 * pi - std::acos(limit) - std::atan(mu);
  scene.window = Seconds{1.2};
  for (const bool rises : {true, false}) {
    scene.phase = rises ? pi / 2 : 4.6;  // held at the start
    const auto watched = watch(scene);
    ASSERT_GE(watched.stretches.size(), 2U);
    EXPECT_NEAR(watched.stretches[1].time, ((rises ? up : down) - scene.phase) / 3, 1e-12);
    EXPECT_EQ(watched.stretches[0].flight.velocity, 0.0);
    const auto& slip = watched.stretches[1];
    EXPECT_EQ(slip.flight.at(1e-3).velocity > 0, rises);
  }
}

TEST(PlanarFriction, TheDisturbanceOfAPressSlowsTheOtherDirection) {
  // x is pressed by P - D cos(w t), which slows y by mu (N + P - D cos(w t)) / m.
  Scene scene = pressed_by_a_turning_force();
  scene.slider_mass_radius = 0;
  scene.wall_lower = 0;
  scene.pull = 2;
  scene.disturbance = 1.1;
  scene.disturbance_frequency = 5;
  scene.across->pull = 0;
  scene.across->start_position = 0;
  scene.across->start_velocity = 2;
  const auto watched = watch(scene);
  ASSERT_GE(watched.across.size(), 1U);
  const double t = watched.across[0].time;
  const double share = scene.friction / scene.mass;
  EXPECT_NEAR(2 * t - share * (2.2 * t * t / 2 - 1.1 * (1 - std::cos(5 * t)) / 25), 1, 1e-14);
  EXPECT_NEAR(watched.across[0].speed, 2 - share * (2.2 * t - 1.1 * std::sin(5 * t) / 5), 1e-14);
  EXPECT_EQ(watched.end.position, 0);
}

TEST(PlanarFriction, AnObliqueImpactTakesSpeedAlongTheWall) {
  for (const double vx : {2.0, -2.0, 0.3}) {
    for (const bool upper : {false, true}) {
      Scene scene;
      scene.fidelity = Fidelity::planar;
      scene.wall_lower = -100;
      scene.wall_upper = 100;
      scene.friction = 0.2;
      scene.start_velocity = vx;
      scene.across = Across<double>{};
      scene.across->restitution_lower = 0.6;
      scene.across->restitution_upper = 0.3;
      scene.across->start_velocity = upper ? 1.7 : -1.7;
      scene.window = Seconds{0.5};
      const auto watched = watch(scene);
      ASSERT_EQ(watched.across.size(), 1U);
      EXPECT_EQ(watched.across[0].wall, upper ? Wall::upper : Wall::lower);
      EXPECT_DOUBLE_EQ(watched.across[0].time, 0.5 / 1.7);
      EXPECT_EQ(watched.across[0].speed, 1.7);
      const double taken = std::min(std::abs(vx), 0.2 * (upper ? 1.3 : 1.6) * 1.7);
      EXPECT_DOUBLE_EQ(watched.end.velocity, vx - std::copysign(taken, vx));
    }
  }
}

/// A free body that loses speed along the walls by their friction alone: straight lines between the
/// walls of a rectangle. [0] is x.
struct Billiard {
  struct Side {
    double lower, upper, restitution_lower, restitution_upper, position, velocity;
  };
  std::array<Side, 2> sides;
  double friction;
  std::array<std::vector<Hit>, 2> hits;

  void play(double end) {
    for (double time = 0;;) {
      std::array<double, 2> left{};
      for (std::size_t i = 0; i < 2; ++i) {
        const Side& s = sides[i];
        left[i] = s.velocity == 0
                      ? infinity
                      : ((s.velocity > 0 ? s.upper : s.lower) - s.position) / s.velocity;
      }
      const std::size_t i = left[0] < left[1] ? 0 : 1;
      if (time + left[i] > end) return;
      time += left[i];
      Side& struck = sides[i];
      Side& other = sides[1 - i];
      other.position += other.velocity * left[i];
      const bool up = struck.velocity > 0;
      const double speed = std::abs(struck.velocity);
      hits[i].push_back({time, up ? Wall::upper : Wall::lower, speed});
      struck.position = up ? struck.upper : struck.lower;
      const double e = up ? struck.restitution_upper : struck.restitution_lower;
      struck.velocity *= -e;
      const double taken = std::min(std::abs(other.velocity), friction * (1 + e) * speed);
      other.velocity -= std::copysign(taken, other.velocity);
    }
  }
};

void expect_hits(const std::vector<Hit>& actual, const std::vector<Hit>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < actual.size(); ++k) {
    ASSERT_EQ(actual[k].wall, expected[k].wall);
    ASSERT_NEAR(actual[k].time, expected[k].time, 1e-9 * expected[k].time);
    ASSERT_NEAR(actual[k].speed, expected[k].speed, 1e-9 * expected[k].speed);
    // Energy never grows, in either direction: nothing drives the body.
    ASSERT_LE(actual[k].speed, k > 0 ? actual[k - 1].speed * (1 + 1e-15) : infinity);
  }
}

TEST(PlanarFriction, AFreeBodyLosesItsSpeedToTheWallsAsInABilliard) {
  RandomScenes scenes(55);
  std::size_t hits = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene drawn = scenes.next_planar();
    Scene scene;
    scene.fidelity = Fidelity::planar;
    scene.restitution_lower = std::max(0.2, drawn.restitution_lower);
    scene.restitution_upper = std::max(0.2, drawn.restitution_upper);
    scene.friction = scenes.within(0, 0.1);
    scene.start_position = scenes.within(0.1, 0.9);
    scene.start_velocity = scenes.within(-2, 2);
    scene.across = Across<double>{};
    scene.across->restitution_lower = std::max(0.2, drawn.across->restitution_lower);
    scene.across->restitution_upper = std::max(0.2, drawn.across->restitution_upper);
    scene.across->start_position = scenes.within(0.1, 0.9);
    scene.across->start_velocity = scenes.within(-2, 2);
    scene.window = Seconds{5};
    Billiard billiard{
        {Billiard::Side{0, 1, scene.restitution_lower, scene.restitution_upper,
                        scene.start_position, scene.start_velocity},
         Billiard::Side{0, 1, scene.across->restitution_lower, scene.across->restitution_upper,
                        scene.across->start_position, scene.across->start_velocity}},
        scene.friction,
        {}};
    billiard.play(5);
    const auto watched = watch(scene);
    expect_hits(watched.hits, billiard.hits[0]);
    expect_hits(watched.across, billiard.hits[1]);
    hits += watched.hits.size();
  }
  EXPECT_GT(hits, 600U);
}

}  // namespace
}  // namespace ricochet::carrier_track
