#include "problems/carrier_track/motion/planar_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "tests/carrier_track/models/watch.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

using Hit = Watched<double>::Hit;

/// The same in x, but for the numbers' last `tolerance`.
void expect_same(const Watched<double>& actual, const Watched<double>& expected,
                 double tolerance = 0) {
  ASSERT_EQ(actual.hits.size(), expected.hits.size());
  for (std::size_t k = 0; k < actual.hits.size(); ++k) {
    ASSERT_NEAR(actual.hits[k].time, expected.hits[k].time, tolerance) << k;
    ASSERT_NEAR(actual.hits[k].speed, expected.hits[k].speed, tolerance) << k;
    ASSERT_EQ(actual.hits[k].wall, expected.hits[k].wall) << k;
  }
  ASSERT_EQ(actual.tops.size(), expected.tops.size());
  for (std::size_t k = 0; k < actual.tops.size(); ++k) {
    ASSERT_NEAR(actual.tops[k].time, expected.tops[k].time, tolerance) << k;
    ASSERT_NEAR(actual.tops[k].position, expected.tops[k].position, tolerance) << k;
  }
  EXPECT_DOUBLE_EQ(actual.end.time, expected.end.time);
  EXPECT_NEAR(actual.end.position, expected.end.position, tolerance);
  EXPECT_NEAR(actual.end.velocity, expected.end.velocity, tolerance);
}

Scene in_x_alone(Scene scene) {
  scene.fidelity = Fidelity::impact;
  return scene;
}

TEST(PlanarModel, WithoutFrictionMovesInXAsTheImpactModelBitForBit) {
  RandomScenes scenes(51);
  std::size_t across = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    scene.friction = 0;
    const auto watched = watch(scene);
    expect_same(watched, watch(in_x_alone(scene)));
    across += watched.across.size();
  }
  EXPECT_GT(across, 3000U) << "y must be lively, to show that it does not matter";
}

TEST(PlanarModel, WithABodyHeldInYMovesInXAsTheImpactModelBitForBit) {
  RandomScenes scenes(52);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    scene.slider_mass_radius = 0;
    scene.pull_rotates = false;
    scene.across = Across<double>{};
    scene.across->pull = 0.5 * scene.friction * scene.normal_force;
    scene.disturbance_frequency = scenes.within(1, 30);
    expect_same(watch(scene), watch(in_x_alone(scene)));
  }
}

TEST(PlanarModel, AConstantPressOnTheWallAddsToTheNormalForce) {
  RandomScenes scenes(53);
  std::size_t hits = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    scene.slider_mass_radius = 0;
    scene.pull_rotates = false;
    const bool upper = scenes.chance(0.5);
    const double press = scenes.within(0.1, 2.0);
    scene.across->wall_upper = scene.across->wall_lower + 1e-3;
    scene.across->start_position = upper ? scene.across->wall_upper : scene.across->wall_lower;
    scene.across->start_velocity = 0;
    scene.across->pull = upper ? press : -press;
    Scene pressed = in_x_alone(scene);
    pressed.normal_force += press;
    const auto expected = watch(pressed);
    const auto actual = watch(scene);
    EXPECT_TRUE(actual.across.empty());
    hits += expected.hits.size();
    expect_same(actual, expected, 1e-9);
  }
  EXPECT_GT(hits, 2000U);
}

TEST(PlanarModel, MovesTheSameInTwoDirectionsThatAreTheSame) {
  RandomScenes scenes(56);
  std::size_t hits = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    scene.pull_rotates = false;
    scene.centrifugal_mass_radius = scene.slider_mass_radius = scene.disturbance = 0;
    scene.across = Across<double>{-scene.pull,
                                  scene.wall_lower,
                                  scene.wall_upper,
                                  scene.restitution_lower,
                                  scene.restitution_upper,
                                  scene.start_position,
                                  scene.start_velocity};
    const auto watched = watch(scene);
    ASSERT_EQ(watched.hits.size(), watched.across.size());
    for (std::size_t k = 0; k < watched.hits.size(); ++k) {
      EXPECT_EQ(watched.hits[k].time, watched.across[k].time);
      EXPECT_EQ(watched.hits[k].speed, watched.across[k].speed);
      EXPECT_EQ(watched.hits[k].wall, watched.across[k].wall);
    }
    hits += watched.hits.size();
  }
  EXPECT_GT(hits, 2000U);
}

/// Impacts of at least a micrometre per second: a body that glides back onto its wall strikes it,
/// or not, by rounding.
std::vector<Hit> distinct(const std::vector<Hit>& hits) {
  std::vector<Hit> result;
  for (const Hit& hit : hits) {
    if (hit.speed > 1e-6) result.push_back(hit);
  }
  return result;
}

void expect_first(const std::vector<Hit>& actual, const std::vector<Hit>& expected, bool mirrored) {
  for (std::size_t k = 0; k < std::min<std::size_t>(12, expected.size()); ++k) {
    ASSERT_LT(k, actual.size());
    ASSERT_NEAR(actual[k].time, expected[k].time, 1e-8);
    ASSERT_NEAR(actual[k].speed, expected[k].speed, 1e-8);
    ASSERT_EQ(actual[k].wall != expected[k].wall, mirrored);
  }
}

/// The directions exchanged: x is what y was, and y is what x was, seen in a mirror, for then the
/// forces of the driver plate, -cos and sin, are those a quarter turn on.
Scene exchanged(const Scene& scene) {
  Scene result = scene;
  const Across<double>& y = *scene.across;
  result.phase = scene.phase + pi / 2;
  if (!scene.pull_rotates) result.pull = -y.pull;
  result.wall_lower = y.wall_lower;
  result.wall_upper = y.wall_upper;
  result.restitution_lower = y.restitution_lower;
  result.restitution_upper = y.restitution_upper;
  result.start_position = y.start_position;
  result.start_velocity = y.start_velocity;
  result.across = Across<double>{scene.pull_rotates ? 0 : scene.pull,
                                 -scene.wall_upper,
                                 -scene.wall_lower,
                                 scene.restitution_upper,
                                 scene.restitution_lower,
                                 -scene.start_position,
                                 -scene.start_velocity};
  return result;
}

TEST(PlanarModel, ExchangingTheDirectionsExchangesTheMotion) {
  RandomScenes scenes(57);
  std::size_t hits = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    scene.centrifugal_mass_radius = scene.disturbance = 0;
    scene.wall_upper = std::min(scene.wall_upper, scene.wall_lower + 5e-3);
    const auto one = watch(scene);
    const auto other = watch(exchanged(scene));
    // Rounding alone tells them apart, and impacts make it grow.
    expect_first(distinct(other.across), distinct(one.hits), true);
    expect_first(distinct(other.hits), distinct(one.across), false);
    hits += one.hits.size();
  }
  EXPECT_GT(hits, 1000U);
}

TEST(PlanarModel, TellsStretchesOfXThatFollowOnEachOther) {
  RandomScenes scenes(58);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = scenes.next_planar();
    const auto watched = watch(scene);
    double time = 0;
    Motion<double> last{scene.start_position, scene.start_velocity, 0};
    for (const auto& stretch : watched.stretches) {
      ASSERT_NEAR(stretch.time, time, 1e-14);
      ASSERT_NEAR(stretch.flight.position, last.position, 1e-13);
      const auto struck = [&](const Hit& hit) { return hit.time == stretch.time; };
      const bool strikes = std::any_of(watched.hits.begin(), watched.hits.end(), struck) ||
                           std::any_of(watched.across.begin(), watched.across.end(), struck);
      if (!strikes) {
        ASSERT_NEAR(stretch.flight.velocity, last.velocity, 1e-14);
      }
      ASSERT_LE(std::abs(stretch.flight.velocity), std::abs(last.velocity) + 1e-14);
      time = stretch.time + stretch.duration;
      last = stretch.flight.at(stretch.duration);
      ASSERT_GE(last.position, scene.wall_lower - 1e-14);
      ASSERT_LE(last.position, scene.wall_upper + 1e-14);
    }
    EXPECT_NEAR(time, watched.end.time, 1e-14);
    EXPECT_NEAR(last.position, watched.end.position, 1e-13);
  }
}

TEST(PlanarModel, UnderAProfileOfOneKnotMovesAsAtAConstantSpeed) {
  RandomScenes scenes(9);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Scene scene = scenes.next_planar();
    const auto steady = watch(scene);
    Scene near = scene;
    near.mass *= 1 + 1e-13;
    const auto other = watch(near);
    const bool tame = other.hits.size() == steady.hits.size() &&
                      std::abs(other.end.position - steady.end.position) < 1e-11;
    if (!tame) continue;
    scene.profile = {{scenes.within(0, 1), scene.omega}};
    const auto profiled = watch(scene);
    ASSERT_EQ(profiled.hits.size(), steady.hits.size());
    for (std::size_t k = 0; k < steady.hits.size(); ++k) {
      EXPECT_NEAR(profiled.hits[k].time, steady.hits[k].time, 1e-8);
    }
    EXPECT_NEAR(profiled.end.position, steady.end.position, 1e-8);
    ++compared;
  }
  EXPECT_GT(compared, 130);
}

TEST(PlanarModel, ASpinUpThrowsTheBodyAcrossByTheSlidersInertia) {
  // y'' = -s (omega' cos alpha - omega^2 sin alpha) / m is the second derivative of -s sin(alpha) /
  // m.
  Scene scene;
  scene.mass = 1.3;
  scene.slider_mass_radius = 0.4;
  scene.phase = 0.7;
  scene.profile = {{0.1, 1.0}, {2.1, 9.0}};
  scene.window = Seconds{2.1};
  scene.fidelity = Fidelity::planar;
  scene.wall_lower = -100;
  scene.wall_upper = 100;
  scene.across = Across<double>{};
  scene.across->wall_lower = -100;
  scene.across->wall_upper = 0.8;
  scene.across->start_position = 0.5;
  const auto watched = watch(scene);
  ASSERT_GE(watched.across.size(), 1U);
  const double t = watched.across[0].time;
  const double share = 0.4 / 1.3;
  const double since = std::max(0.0, t - 0.1);
  const double alpha = 0.7 + t + 2.0 * since * since;
  const double y = 0.5 - share * (std::sin(alpha) - std::sin(0.7)) + share * std::cos(0.7) * t;
  EXPECT_NEAR(y, 0.8, 1e-13);
  EXPECT_GT(t, 0.1);
}

}  // namespace
}  // namespace ricochet::carrier_track
