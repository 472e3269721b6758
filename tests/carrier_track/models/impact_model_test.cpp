#include "problems/carrier_track/motion/impact_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "ricochet/machine.h"
#include "tests/carrier_track/models/expect_close.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

/// A ball dropped from 50 m on a floor at 0: its impacts are a geometric series.
Scene bouncing_ball() {
  Scene scene;
  scene.wall_upper = infinity;
  scene.start_position = 50.0;
  scene.pull = 9.8;
  scene.restitution_lower = 0.8;
  scene.window = Seconds{40.0};
  return scene;
}

TEST(ImpactModel, BouncingBallStrikesAtTheClosedFormTimes) {
  const auto watched = watch(bouncing_ball());
  const double e = 0.8;
  const double first = std::sqrt(2 * 50.0 / 9.8);
  ASSERT_GE(watched.hits.size(), 100U);
  for (std::size_t k = 0; k < 100; ++k) {
    const double power = std::pow(e, static_cast<double>(k));
    expect_close(watched.hits[k].time, first * (1 + e - 2 * e * power) / (1 - e));
    expect_close(watched.hits[k].speed, 9.8 * first * power);
    EXPECT_EQ(watched.hits[k].wall, Wall::lower);
  }
  // The same times from the closed form by another program, fifteen digits.
  EXPECT_NEAR(watched.hits[0].time, 3.1943828249997, 1e-13);
  EXPECT_NEAR(watched.hits[1].time, 8.30539534499922, 1e-13);
  EXPECT_NEAR(watched.hits[2].time, 12.3942053609988, 1e-12);
}

TEST(ImpactModel, BouncingBallComesToRestAtItsAccumulationTime) {
  for (const double e : {0.0, 0.1, 0.5, 0.8, 0.97}) {
    Scene scene = bouncing_ball();
    scene.restitution_lower = e;
    scene.window = Seconds{1000.0};
    const auto watched = watch(scene);
    const double first = std::sqrt(2 * 50.0 / 9.8);
    // The last stretch is the rest until the end of the window.
    const auto& rest = watched.stretches.back();
    expect_close(rest.time, first * (1 + e) / (1 - e));
    EXPECT_EQ(rest.flight.harmonics, 0);
    EXPECT_EQ(watched.end.position, 0.0);
    EXPECT_EQ(watched.end.velocity, 0.0);
    expect_close(watched.end.time, 1000.0);
    if (e == 0.8) {
      EXPECT_NEAR(rest.time, 28.7494454249973, 1e-12);
    }
  }
}

TEST(ImpactModel, BouncingBallIsListedUntilItRests) {
  const auto watched = watch(bouncing_ball());
  EXPECT_LE(watched.hits.back().speed * 0.8, resting_speed);
  EXPECT_GT(watched.hits[watched.hits.size() - 2].speed * 0.8, resting_speed);
}

TEST(ImpactModel, BouncingBallIsFollowedAsFarAsItsImpactsCount) {
  Scene scene = bouncing_ball();
  for (const double slowest : {1e-3, 1e-9, 3e-12, 1e-15}) {
    scene.counting_limit = slowest;
    const double speed = std::sqrt(2 * 9.8 * 50);
    std::size_t expected = 0;
    while (speed * std::pow(0.8, static_cast<double>(expected)) > slowest) ++expected;
    const auto watched = watch(scene);
    std::size_t count = 0;
    for (const auto& hit : watched.hits) count += hit.speed > slowest ? 1 : 0;
    EXPECT_EQ(count, expected) << slowest;
    // What is left out is too slow for any surrogate.
    EXPECT_LE(watched.hits.back().speed * 0.8, 1e-3 * slowest);
  }
}

TEST(ImpactModel, FrictionShortensEveryHopOfABouncingBall) {
  // Up at press + friction, down at press - friction: speeds shrink by e sqrt(down / up).
  Scene scene = bouncing_ball();
  scene.friction = 0.2;
  scene.normal_force = 5.0;
  const auto watched = watch(scene);
  const double up = 9.8 + 1.0;
  const double down = 9.8 - 1.0;
  const double ratio = 0.8 * std::sqrt(down / up);
  double time = std::sqrt(2 * 50.0 / down);
  double speed = down * time;
  for (std::size_t k = 0; k < 60; ++k) {
    expect_close(watched.hits[k].time, time);
    expect_close(watched.hits[k].speed, speed);
    time += 0.8 * speed * (1 / up + 1 / std::sqrt(up * down));
    speed *= ratio;
  }
  const double sum = 0.8 * watched.hits[0].speed * (1 / up + 1 / std::sqrt(up * down));
  expect_close(watched.stretches.back().time, watched.hits[0].time + sum / (1 - ratio));
}

TEST(ImpactModel, AFreeBodyKeepsItsPaceBetweenElasticWalls) {
  Scene scene;
  scene.wall_lower = -0.25;
  scene.wall_upper = 0.5;
  scene.start_position = 0.0;
  scene.start_velocity = 2.0;
  scene.window = Seconds{1000.0};
  const auto watched = watch(scene);
  ASSERT_EQ(watched.hits.size(), 2667U);
  for (std::size_t k = 0; k < watched.hits.size(); ++k) {
    expect_close(watched.hits[k].time, 0.25 + 0.375 * static_cast<double>(k));
    EXPECT_EQ(watched.hits[k].wall, k % 2 == 0 ? Wall::upper : Wall::lower);
    EXPECT_EQ(watched.hits[k].speed, 2.0);
  }
}

TEST(ImpactModel, EachWallHasItsOwnRestitution) {
  Scene scene;
  scene.restitution_lower = 0.5;
  scene.restitution_upper = 0.9;
  scene.start_velocity = 2.0;
  scene.window = Seconds{20.0};
  const auto watched = watch(scene);
  double time = 0.25;
  double speed = 2.0;
  ASSERT_GE(watched.hits.size(), 6U);
  for (std::size_t k = 0; k < watched.hits.size(); ++k) {
    expect_close(watched.hits[k].time, time);
    expect_close(watched.hits[k].speed, speed);
    speed *= k % 2 == 0 ? 0.9 : 0.5;
    time += 1.0 / speed;
  }
}

TEST(ImpactModel, AnElasticBallKeepsItsEnergyOverAHundredThousandImpacts) {
  Scene scene;
  scene.pull = 9.8;
  scene.wall_upper = 0.5;
  scene.start_position = 0.25;
  scene.start_velocity = 3.0;
  scene.mass = 2.0;
  const double g = 4.9;
  const double down = std::sqrt(9.0 + 2 * g * 0.25);
  const double up = std::sqrt(down * down - 2 * g * 0.5);
  const double period = 2 * (down - up) / g;
  scene.window = Seconds{60'000 * period};
  const auto watched = watch(scene);
  ASSERT_NEAR(static_cast<double>(watched.hits.size()), 120'000.0, 1.0);
  const double first = (3.0 - up) / g;
  double worst_speed = 0;
  double worst_time = 0;
  for (std::size_t k = 0; k < watched.hits.size(); ++k) {
    const double speed = k % 2 == 0 ? up : down;
    const double time = first + 0.5 * period * static_cast<double>(k);
    worst_speed = std::max(worst_speed, std::abs(watched.hits[k].speed / speed - 1));
    worst_time = std::max(worst_time, std::abs(watched.hits[k].time / time - 1));
  }
  EXPECT_LT(worst_speed, 1e-11);
  EXPECT_LT(worst_time, 1e-11);
}

TEST(ImpactModel, RestsWithoutAnImpactAgainstTheWallItStartsAt) {
  for (const bool upper : {false, true}) {
    Scene scene;
    scene.start_position = upper ? 1.0 : 0.0;
    scene.pull = upper ? -2.0 : 2.0;
    const auto watched = watch(scene);
    EXPECT_TRUE(watched.hits.empty());
    EXPECT_EQ(watched.end.position, scene.start_position);
    EXPECT_EQ(watched.end.velocity, 0.0);
  }
}

TEST(ImpactModel, StrikesAtOnceTheWallItStartsAtAndMovesInto) {
  Scene scene;
  scene.start_position = 0.0;
  scene.start_velocity = -2.0;
  scene.restitution_lower = 0.5;
  scene.window = Seconds{0.5};
  const auto watched = watch(scene);
  ASSERT_EQ(watched.hits.size(), 1U);
  EXPECT_EQ(watched.hits[0].time, 0.0);
  EXPECT_EQ(watched.hits[0].speed, 2.0);
  expect_close(watched.end.position, 0.5);
}

TEST(ImpactModel, LeavesTheWallWhenTheNetForceTurns) {
  // A pull that turns presses until cos = 0; then x'' = -p cos(w t) integrates in closed form.
  for (const double mu : {0.0, 0.3}) {
    Scene scene;
    scene.wall_upper = infinity;
    scene.start_position = 0.0;
    scene.mass = 0.5;
    scene.pull = 0.7;
    scene.pull_rotates = true;
    scene.omega = 2.0;
    scene.friction = mu;
    scene.normal_force = 1.5;
    scene.window = Seconds{1.4};
    const auto watched = watch(scene);
    const double p = scene.pull / scene.mass;
    const double f = mu * 1.5 / scene.mass;
    const double leave = std::acos(-f / p) / 2.0;
    ASSERT_EQ(watched.stretches.size(), 2U);
    expect_close(watched.stretches[1].time, leave);
    const double s = 1.4 - leave;
    const double velocity = -p / 2.0 * (std::sin(2.8) - std::sin(2 * leave)) - f * s;
    const double position = p / 4.0 * (std::cos(2.8) - std::cos(2 * leave)) +
                            p / 2.0 * std::sin(2 * leave) * s - f * s * s / 2;
    expect_close(watched.end.velocity, velocity);
    expect_close(watched.end.position, position);
  }
}

TEST(ImpactModel, SticksWhereRestitutionIsZero) {
  Scene scene = bouncing_ball();
  scene.restitution_lower = 0.0;
  const auto watched = watch(scene);
  EXPECT_EQ(watched.hits.size(), 1U);
  EXPECT_EQ(watched.end.position, 0.0);
}

TEST(ImpactModel, EndsExactlyWithTheWindow) {
  Scene scene;
  scene.window = Seconds{7.25};
  EXPECT_EQ(watch(scene).end.time, 7.25);
}

TEST(ImpactModel, AGrazingImpactHasTheSpeedOfItsOverlap) {
  // Thrown up at 4 m/s against 8 m/s^2, the apex is at exactly 1 m.
  Scene scene;
  scene.start_position = 0.0;
  scene.start_velocity = 4.0;
  scene.pull = 8.0;
  scene.restitution_lower = 0.0;
  scene.window = Seconds{2.0};
  for (const double overlap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    scene.wall_upper = 1.0 - overlap;
    auto watched = watch(scene);
    ASSERT_EQ(watched.hits.size(), 2U) << overlap;
    EXPECT_EQ(watched.hits[0].wall, Wall::upper);
    // v = sqrt(2 a d) for the gap as it was rounded.
    expect_close(watched.hits[0].speed, std::sqrt(16.0 * (1.0 - scene.wall_upper)), 1e-7);
    scene.wall_upper = 1.0 + overlap;
    watched = watch(scene);
    ASSERT_EQ(watched.hits.size(), 1U) << overlap;
    expect_close(watched.hits[0].speed, 4.0);
  }
  scene.wall_upper = 1.0;
  const auto touching = watch(scene);
  for (const auto& hit : touching.hits) {
    if (hit.wall == Wall::upper) {
      EXPECT_LT(hit.speed, 1e-7);
    }
  }
  expect_close(touching.hits.back().speed, 4.0);
}

TEST(ImpactModel, RefusesAWindowWithTooManyImpacts) {
  Scene scene;
  scene.start_velocity = 1e3;
  scene.window = Seconds{1.0001e4};
  Observer nobody;
  EXPECT_THROW(ImpactModel<double>(scene).run(nobody), std::runtime_error);
}

TEST(ImpactModel, EndsWhereTheForcesBalanceFrictionButForRounding) {
  // 0.1 + 0.2 exceeds 0.3 in binary, and other decimal sums fall short.
  for (int i = 1; i < 30; ++i) {
    for (int k = 1; k < 30; ++k) {
      for (const double mass : {1.0, 1.2, 3.0}) {
        Scene scene;
        scene.mass = mass;
        scene.omega = 0.0;
        scene.pull = -0.1 * i;
        scene.disturbance = 0.1 * k;
        scene.disturbance_frequency = 0.0;
        scene.friction = 0.1;
        scene.normal_force = i + k;
        const auto watched = watch(scene);
        EXPECT_EQ(watched.end.time, 1.0);
        EXPECT_NEAR(watched.end.position, 0.5, 1e-14);
      }
    }
  }
}

TEST(ImpactModel, FliesOffWhereTheForceTurnsBeforeTheLastHopsWouldEnd) {
  // Strikes so slowly that it would rest, on a wall to which x'' = sin t - 1e-10 hardly presses it.
  Scene scene;
  scene.wall_upper = infinity;
  scene.start_position = 0.0;
  scene.start_velocity = -1e-9;
  scene.restitution_lower = 0.5;
  scene.pull = 1e-10;
  scene.centrifugal_mass_radius = 1.0;
  scene.phase = -pi / 2;
  expect_close(watch(scene).end.position, 1 - std::sin(1.0) + 0.5e-9 - 0.5e-10);
}

TEST(ImpactModel, SpendsNoEffortOnForcesThatCancelButForRounding) {
  Scene scene;
  scene.pull = -0.3;
  scene.pull_rotates = true;
  for (const bool opposed : {false, true}) {
    scene.disturbance = opposed ? 0.3 : -0.3;
    scene.phase = opposed ? pi : 0.0;
    for (const double omega : {1.0, 0.3, 7.7, 10.0}) {
      scene.omega = scene.disturbance_frequency = omega;
      for (const double friction : {0.0, 0.4}) {
        scene.friction = friction;
        scene.normal_force = 1.0;
        const auto watched = watch(scene);
        EXPECT_NEAR(watched.end.position, 0.5, 1e-14);
        EXPECT_LT(watched.end.evaluations, 1000);
      }
    }
  }
  // Here the rounding of larger forces leaves the plate's amplitude 7e-16 m/s^2 too great.
  scene.centrifugal_mass_radius = scene.slider_mass_radius = 0.3;
  scene.friction = 0.0;
  EXPECT_LT(watch(scene).end.evaluations, 1000);
}

}  // namespace
}  // namespace ricochet::carrier_track
