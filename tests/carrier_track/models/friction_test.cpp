#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/carrier_track/models/expect_close.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

/// Far from any wall, friction 0.25 x 2 N on 0.8 kg.
Scene block() {
  Scene scene;
  scene.wall_lower = -100.0;
  scene.wall_upper = infinity;
  scene.start_position = 0.0;
  scene.mass = 0.8;
  scene.friction = 0.25;
  scene.normal_force = 2.0;
  return scene;
}
constexpr double friction = 0.25 * 2.0 / 0.8;  // [m/s^2]

/// The block under a force friction / share sin(omega t), which exceeds friction from the angle
/// asin(share) on.
Scene shaken_block(double share) {
  Scene scene = block();
  scene.omega = 3.0;
  scene.centrifugal_mass_radius = friction * scene.mass / share / 9.0;
  scene.phase = -pi / 2;
  return scene;
}

TEST(Friction, StopsASlidingBodyAtTheClosedFormTimeAndPlaceForGood) {
  for (const double v0 : {1e-6, 0.1, -3.0}) {
    Scene scene = block();
    scene.start_velocity = v0;
    scene.window = Seconds{10.0};
    const auto watched = watch(scene);
    ASSERT_EQ(watched.stretches.size(), 2U);
    expect_close(watched.stretches[0].duration, std::abs(v0) / friction);
    expect_close(watched.end.position, v0 * std::abs(v0) / (2 * friction));
    EXPECT_EQ(watched.end.velocity, 0.0);
    EXPECT_EQ(watched.stretches[1].flight.harmonics, 0);
    EXPECT_EQ(watched.stretches[1].flight.velocity, 0.0);
  }
}

TEST(Friction, HoldsABodyAgainstAnyForceWithinItsBand) {
  for (const double pull : {-0.4998, 0.0, 0.4998}) {
    Scene scene = block();
    scene.pull = pull;
    scene.disturbance = 0.0001;
    scene.window = Seconds{100.0};
    EXPECT_EQ(watch(scene).end.position, 0.0);
  }
}

TEST(Friction, YieldsToTheSmallestExcessOfForce) {
  for (const double sign : {-1.0, 1.0}) {
    Scene scene = block();
    const double excess = 0x1p-40;  // exact beside the 0.5 N of friction
    scene.mass = 1.0;
    scene.pull = -sign * (0.5 + excess);
    scene.window = Seconds{1000.0};
    expect_close(watch(scene).end.position, sign * 0.5 * excess * 1e6);
  }
}

TEST(Friction, LetsABodySlipWhenAGrowingForceLeavesItsBand) {
  for (const double share : {0.1, 0.5, 0.9, 0.999, 1 - 1e-9}) {
    Scene scene = shaken_block(share);
    const double release = std::asin(share) / 3.0;
    const double end = release + 0.1 * (pi / 2 - std::asin(share)) / 3.0;
    scene.window = Seconds{end};
    const auto watched = watch(scene);
    ASSERT_EQ(watched.stretches.size(), 2U) << share;
    // The force meets the edge of the band ever more flatly: its time is worth fewer digits.
    expect_close(watched.stretches[1].time, release, 1e-12 + 1e-15 / (1 - share * share));
    const double a = friction / share;
    const double s = end - release;
    const double velocity =
        a / 3.0 * (std::cos(3.0 * release) - std::cos(3.0 * end)) - friction * s;
    EXPECT_NEAR(watched.end.velocity, velocity, 1e-15);
  }
}

TEST(Friction, TellsAForceThatLeavesItsBandByABillionthFromOneThatDoesNot) {
  Scene scene = shaken_block(1 + 1e-9);
  scene.window = Seconds{20.0};
  EXPECT_EQ(watch(scene).end.position, 0.0);
  EXPECT_EQ(watch(scene).stretches.size(), 1U);
  EXPECT_GT(watch(shaken_block(1 - 1e-9)).stretches.size(), 1U);
}

TEST(Friction, SticksAndSlipsToAndFroInTheClosedFormRhythm) {
  // Slips from the angle b = asin(share) until cos b - cos u = share (u - b), then holds until the
  // force leaves the band on the other side, half a turn after b.
  const double share = 0.9;
  Scene scene = shaken_block(share);
  scene.window = Revolutions{50.25};
  const auto watched = watch(scene);
  const double b = std::asin(share);
  double lower = b + 0.1;
  double upper = pi;
  for (int i = 0; i < 100; ++i) {
    const double u = (lower + upper) / 2;
    (std::cos(b) - std::cos(u) > share * (u - b) ? lower : upper) = u;
  }
  const double a = friction / share;
  const double slide = (upper - b) / 3.0;
  const double reach = a / 9.0 *
                       (std::cos(b) * (upper - b) - std::sin(upper) + std::sin(b) -
                        share * (upper - b) * (upper - b) / 2);
  ASSERT_LT(std::sin(upper), share) << "else it would not stick";
  ASSERT_EQ(watched.stretches.size(), 202U);
  for (std::size_t k = 0; k + 2 < watched.stretches.size(); k += 2) {
    const auto& hold = watched.stretches[k];
    const auto& slip = watched.stretches[k + 1];
    const double half_turns = static_cast<double>(k / 2);
    EXPECT_NEAR(hold.flight.position, (k / 2) % 2 == 0 ? 0.0 : reach, 1e-13);
    EXPECT_EQ(hold.flight.velocity, 0.0);
    expect_close(slip.time, (half_turns * pi + b) / 3.0);
    expect_close(slip.duration, slide, 1e-11);
  }
}

TEST(Friction, TurnsABodyWithoutHoldingItWhereTheForceIsStronger) {
  // Up against gravity and friction, down against friction alone.
  Scene scene = block();
  scene.pull = 3.0;
  scene.start_velocity = 2.0;
  scene.window = Seconds{2.0};
  const auto watched = watch(scene);
  const double up = 3.0 / 0.8 + friction;
  const double down = 3.0 / 0.8 - friction;
  ASSERT_EQ(watched.stretches.size(), 2U);
  expect_close(watched.stretches[0].duration, 2.0 / up);
  const double left = 2.0 - 2.0 / up;
  expect_close(watched.end.velocity, -down * left);
  expect_close(watched.end.position, 2.0 / up - down * left * left / 2);
}

TEST(Friction, StopsABodyThatLeavesAWallWhereTheForceCannotBringItBack) {
  Scene scene;
  scene.start_velocity = -2.0;
  scene.friction = 0.1;
  scene.normal_force = 10.0;
  scene.pull = 0.5;
  scene.restitution_lower = 0.5;
  scene.window = Seconds{10.0};
  const auto watched = watch(scene);
  ASSERT_EQ(watched.hits.size(), 1U);
  const double speed = std::sqrt(4.0 - 2 * 0.5 * 0.5);
  expect_close(watched.hits[0].speed, speed);
  expect_close(watched.end.position, 0.25 * speed * speed / (2 * 1.5));
  EXPECT_EQ(watched.end.velocity, 0.0);
}

}  // namespace
}  // namespace ricochet::carrier_track
