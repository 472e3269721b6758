#include "problems/carrier_track/motion/profile_forces.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"

namespace ricochet::carrier_track {
namespace {

/// A profile of a few knots around the speed of a scene, with a window that reaches beyond it.
std::vector<SpeedKnot<double>> random_profile(RandomScenes& draws, double omega) {
  std::vector<SpeedKnot<double>> profile;
  double time = draws.chance(0.5) ? 0.0 : draws.within(0.0, 0.3);
  const int knots = draws.chance(0.3) ? 1 : 4;
  for (int k = 0; k < knots; ++k) {
    profile.push_back({time, omega * draws.within(0.3, 1.7)});
    time += draws.within(0.05, 0.4);
  }
  return profile;
}

void expect_same(const Recording& a, const Recording& b, double tolerance) {
  ASSERT_EQ(a.impacts.size(), b.impacts.size());
  for (std::size_t i = 0; i < a.impacts.size(); ++i) {
    EXPECT_EQ(a.impacts[i].wall, b.impacts[i].wall);
    EXPECT_NEAR(a.impacts[i].time, b.impacts[i].time, tolerance);
    EXPECT_NEAR(a.impacts[i].speed, b.impacts[i].speed, tolerance);
  }
  EXPECT_NEAR(a.end.position, b.end.position, tolerance);
}

/// Scenes whose paths do not make much of a change in the last digit.
bool is_tame(const Scene& scene, const Recording& recording) {
  Scene near = scene;
  near.mass *= 1 + 1e-13;
  const Recording other = record(near, 0.25, 0);
  if (other.impacts.size() != recording.impacts.size()) return false;
  return std::abs(other.end.position - recording.end.position) < 1e-11;
}

TEST(ProfileForces, OfOneKnotAreThoseOfAConstantSpeed) {
  RandomScenes draws(1);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = draws.next();
    const Recording steady = record(scene, 0.25, 0);
    if (!is_tame(scene, steady)) continue;
    scene.profile = {{draws.within(0, 1), scene.omega}};
    const Recording profiled = record(scene, 0.25, 0);
    expect_same(steady, profiled, 1e-9);
    EXPECT_NEAR(steady.end.time, profiled.end.time, 1e-14 * steady.end.time);
    if (HasFailure()) return;
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST(ProfileForces, DoNotMindAKnotWithinALeg) {
  RandomScenes draws(2);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Scene scene = draws.next();
    scene.profile = {{0.0, scene.omega}, {0.8, 2 * scene.omega}};
    const Recording whole = record(scene, 0.25, 0);
    if (!is_tame(scene, whole)) continue;
    scene.profile = {{0.0, scene.omega},
                     {0.2, 1.25 * scene.omega},
                     {0.3, 1.375 * scene.omega},
                     {0.8, 2 * scene.omega}};
    expect_same(whole, record(scene, 0.25, 0), 1e-9);
    if (HasFailure()) return;
    ++compared;
  }
  EXPECT_GT(compared, 150);
}

TEST(ProfileForces, ASpinUpWithoutOtherForcesActsThroughTheSlidersAlone) {
  // x'' = -s (omega' sin alpha + omega^2 cos alpha) / m is the second derivative of s cos(alpha) /
  // m.
  Scene scene;
  scene.mass = 1.3;
  scene.wall_lower = -100;
  scene.wall_upper = 100;
  scene.start_position = 0.5;
  scene.start_velocity = 0.02;
  scene.slider_mass_radius = 0.4;
  scene.phase = 0.7;
  scene.profile = {{0.1, 1.0}, {2.1, 9.0}};
  scene.window = Seconds{2.1};
  const double alpha = 0.7 + 0.1 + 2.0 * 5.0;
  const double share = 0.4 / 1.3;
  const double expected = 0.5 + 0.02 * 2.1 + share * (std::cos(alpha) - std::cos(0.7)) +
                          share * std::sin(0.7) * 1.0 * 2.1;
  EXPECT_NEAR(record(scene, 0.25, 0).end.position, expected, 1e-13);
}

TEST(ProfileForces, CarryDerivativesWithRespectToTheKnots) {
  using Jet = ceres::Jet<double, 1>;
  RandomScenes draws(4);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = draws.next();
    scene.profile = random_profile(draws, scene.omega);
    if (scene.profile.size() < 4) continue;
    const std::size_t knot = i % 4;
    BasicScene<Jet> dual = lifted<Jet>(scene);
    dual.profile[knot].omega.v[0] = 1;
    const Watched<Jet> watched = watch(dual);
    const auto shifted = [&](double h) {
      Scene near = scene;
      near.profile[knot].omega += h;
      return watch(near);
    };
    const double h = 1e-6 * scene.omega;
    const auto up = shifted(h);
    const auto down = shifted(-h);
    // The derivative of the first few impacts, where the path is still tame.
    const std::size_t hits = std::min<std::size_t>(watched.hits.size(), 4);
    if (up.hits.size() < hits || down.hits.size() < hits) continue;
    for (std::size_t k = 0; k < hits; ++k) {
      const double slope = (up.hits[k].time - down.hits[k].time) / (2 * h);
      const double exact = watched.hits[k].time.v[0];
      if (std::abs(exact) > 1) break;  // near a graze
      EXPECT_NEAR(exact, slope, 2e-5 * (1e-2 + std::abs(exact)));
      ++compared;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, 200);
}

TEST(ProfileForces, CompliantWallsConvergeToHardOnesUnderThem) {
  Scene scene;
  scene.mass = 1.2;
  scene.wall_upper = 1e-3;
  scene.restitution_lower = scene.restitution_upper = 0.4;
  scene.friction = 0.1;
  scene.normal_force = 1.0;
  scene.pull = 0.5;
  scene.centrifugal_mass_radius = 0.1;
  scene.slider_mass_radius = 0.02;
  scene.start_position = 0.5e-3;
  scene.profile = {{0.0, 2.0}, {0.7, 8.0}, {1.0, 5.0}};
  scene.window = Seconds{1.5};
  scene.contact_law = ContactLaw::exact_restitution;
  const Recording hard = record(scene, 0.25, 0);
  ASSERT_GT(hard.impacts.size(), 8U);
  scene.fidelity = Fidelity::compliant;
  double before = 1;
  for (const double stiffness : {1e14, 1e18, 1e22}) {
    scene.stiffness = stiffness;
    const Recording soft = record(scene, 0.25, 0);
    double error = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_EQ(soft.impacts[k].wall, hard.impacts[k].wall);
      error = std::max(error, std::abs(soft.impacts[k].time - hard.impacts[k].time));
    }
    EXPECT_LT(error, 0.1 * before) << stiffness;  // K^-0.4 is a factor of 40
    before = error;
  }
  EXPECT_LT(before, 1e-6);
}

}  // namespace
}  // namespace ricochet::carrier_track
