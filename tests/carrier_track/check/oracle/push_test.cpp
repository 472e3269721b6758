#include "problems/carrier_track/check/push.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"

namespace ricochet::carrier_track {
namespace {

Push push_of(const Scene& scene, long double until) {
  return Push(applied_force(scene), scene.mass, until);
}

TEST(Push, OfAWholeIsThatOfItsParts) {
  RandomScenes scenes(1);
  for (int i = 0; i < 1000; ++i) {
    const Push push = push_of(scenes.next(), 10);
    const long double start = scenes.within(0, 2);
    const long double reach = std::min(push.known_until(start) - start, 1.0L);
    const long double first = reach * scenes.log_within(1e-9, 0.5);
    const long double second = reach * scenes.log_within(1e-9, 0.5);
    const Pushed whole = PushFrom(push, start).after(first + second);
    const Pushed one = PushFrom(push, start).after(first);
    const Pushed two = PushFrom(push, start + first).after(second);
    const long double time = first + second;
    const auto difference = [](long double a, long double b) { return static_cast<double>(a - b); };
    ASSERT_NEAR(difference(one.distance + one.speed * second + two.distance, whole.distance), 0,
                static_cast<double>(1e-16L * push.strength() * time * time));
    ASSERT_NEAR(difference(one.speed + two.speed, whole.speed), 0,
                static_cast<double>(1e-16L * push.strength() * time));
    ASSERT_NEAR(difference(two.acceleration, whole.acceleration), 0,
                static_cast<double>(1e-16L * push.strength()));
  }
}

TEST(Push, KeepsTheDigitsOfTheShortestHop) {
  Scene scene;
  scene.centrifugal_mass_radius = 1;
  scene.omega = 1;
  scene.phase = 1;
  for (const long double t : {1e-6L, 1e-9L, 1e-12L}) {
    // cos(1 + t) integrated twice, to the order of what is left out.
    const long double expected =
        t * t * (std::cos(1.0L) / 2 - t * (std::sin(1.0L) / 6 + t * std::cos(1.0L) / 24));
    const long double actual = PushFrom(push_of(scene, 1), 0).after(t).distance;
    EXPECT_NEAR(static_cast<double>(actual / expected - 1), 0, 1e-18);
  }
}

TEST(Push, StaysWithinItsBounds) {
  RandomScenes scenes(2);
  for (int i = 0; i < 1000; ++i) {
    Scene scene = scenes.next();
    if (scenes.chance(0.5)) scene.disturbance_frequency = scene.omega * (1 + 1e-6);
    const long double time = scenes.within(0, 2);
    const Push push = push_of(scene, time);
    const Pushed now = PushFrom(push, time).after(0);
    ASSERT_LE(std::abs(now.acceleration), push.strength() * (1 + 1e-15L));
    ASSERT_LE(std::abs(now.jerk), push.bound(1) * (1 + 1e-15L));
    ASSERT_LE(std::abs(now.snap), push.bound(2) * (1 + 1e-15L));
  }
}

TEST(Push, OfTwoWavesThatAlmostCancelHasASmallBound) {
  Scene scene;
  scene.centrifugal_mass_radius = 1;
  scene.omega = 2;
  scene.disturbance_frequency = 2 * (1 + 1e-9);
  scene.disturbance = -4 * (1 + 1e-9);
  const Push push = push_of(scene, 1);
  EXPECT_NEAR(static_cast<double>(push.strength()), 8, 1e-7);
  EXPECT_LT(push.bound(1), 1e-7L);
  EXPECT_GT(push.bound(1), 1e-9L);
}

/// Simpson's rule, in steps much finer than the force changes.
struct Integrated {
  long double speed = 0, distance = 0;
};

Integrated integrated(const PushTerm& term, long double from, long double elapsed) {
  constexpr int steps = 4000;
  const auto acceleration = [&](long double u) {
    const auto& [a, p] = term;
    return (a[0] + u * (a[1] + u * a[2])) * std::cos(p[0] + u * (p[1] + u * p[2]));
  };
  Integrated sum;
  const long double h = elapsed / steps;
  for (int k = 0; k <= steps; ++k) {
    const long double weight = (k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2) * h / 3;
    const long double value = acceleration(from + h * k);
    sum.speed += weight * value;
    sum.distance += weight * value * (elapsed - h * k);
  }
  return sum;
}

TEST(Push, MovesABodyAsItsIntegralSays) {
  for (const PushTerm& term :
       {PushTerm{{1, 2, -3}, {0.3L, 5, 2}}, PushTerm{{0.5L, 0, 0}, {0, 0, 0}},
        PushTerm{{2, 0, 1}, {-1, 0, 40}}, PushTerm{{1, 1, 1}, {0, 0, 0}}}) {
    const Push push({{0, {term}}}, 1, 2);
    for (const long double start : {0.0L, 0.7L}) {
      const long double elapsed = std::min(push.known_until(start) - start, 0.5L);
      const Pushed moved = PushFrom(push, start).after(elapsed);
      const Integrated expected = integrated(term, start, elapsed);
      EXPECT_NEAR(static_cast<double>(moved.speed - expected.speed), 0, 1e-15);
      EXPECT_NEAR(static_cast<double>(moved.distance - expected.distance), 0, 1e-15);
    }
  }
}

TEST(Push, HasTheDerivativesOfItsAcceleration) {
  const Push push({{0, {{{1, 2, -3}, {0.3L, 5, 2}}}}}, 1, 2);
  const PushFrom from(push, 0.4L);
  const long double t = 0.05L, h = 1e-5L;
  const Pushed before = from.after(t - h), now = from.after(t), after = from.after(t + h);
  EXPECT_NEAR(static_cast<double>((after.acceleration - before.acceleration) / (2 * h) / now.jerk),
              1, 1e-8);
  EXPECT_NEAR(static_cast<double>((after.jerk - before.jerk) / (2 * h) / now.snap), 1, 1e-8);
  EXPECT_LE(std::abs(now.jerk), push.bound(1));
  EXPECT_LE(std::abs(now.snap), push.bound(2));
}

TEST(Push, EndsAtTheNextPiece) {
  const Push push({{0, {}}, {0.5L, {{{1, 0, 0}, {0, 100, 0}}}}}, 1, 2);
  EXPECT_EQ(push.known_until(0.1L), 0.5L);
  EXPECT_EQ(push.smooth_until(0.1L), 0.5L);
  EXPECT_NEAR(static_cast<double>(push.known_until(0.5L)), 0.53, 1e-12);  // 3 rad
  EXPECT_EQ(PushFrom(push, 0.1L).after(0.2L).acceleration, 0);
  EXPECT_EQ(PushFrom(push, 0.5L).after(0).acceleration, 1);
}

}  // namespace
}  // namespace ricochet::carrier_track
