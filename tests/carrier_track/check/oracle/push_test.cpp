#include "problems/carrier_track/check/push.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/check/random_scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(Push, OfAWholeIsThatOfItsParts) {
  RandomScenes scenes(1);
  for (int i = 0; i < 1000; ++i) {
    const Push push(scenes.next());
    const long double start = scenes.within(0, 2);
    const long double first = scenes.log_within(1e-9, 1);
    const long double second = scenes.log_within(1e-9, 1);
    const Pushed whole = PushFrom(push, start).after(first + second);
    const Pushed one = PushFrom(push, start).after(first);
    const Pushed two = PushFrom(push, start + first).after(second);
    const long double time = first + second;
    const long double force = std::abs(push.steady) + push.size(0);
    const auto difference = [](long double a, long double b) { return static_cast<double>(a - b); };
    ASSERT_NEAR(difference(one.distance + one.speed * second + two.distance, whole.distance), 0,
                static_cast<double>(1e-16L * force * time * time));
    ASSERT_NEAR(difference(one.speed + two.speed, whole.speed), 0,
                static_cast<double>(1e-16L * force * time));
    ASSERT_NEAR(difference(two.acceleration, whole.acceleration), 0,
                static_cast<double>(1e-16L * force));
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
    const long double actual = PushFrom(Push(scene), 0).after(t).distance;
    EXPECT_NEAR(static_cast<double>(actual / expected - 1), 0, 1e-18);
  }
}

TEST(Push, StaysWithinItsBounds) {
  RandomScenes scenes(2);
  for (int i = 0; i < 1000; ++i) {
    Scene scene = scenes.next();
    if (scenes.chance(0.5)) scene.disturbance_frequency = scene.omega * (1 + 1e-6);
    const Push push(scene);
    const long double time = scenes.within(0, 2);
    const Pushed now = PushFrom(push, time).after(0);
    ASSERT_LE(std::abs(now.jerk), push.bound(1, time) * (1 + 1e-15L));
    ASSERT_LE(std::abs(now.snap), push.bound(2, time) * (1 + 1e-15L));
    ASSERT_LE(push.bound(1, time), push.size(1));
  }
}

TEST(Push, RefusesASpeedProfile) {
  Scene scene;
  scene.profile = {{0, 1}};
  EXPECT_THROW(Push{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
