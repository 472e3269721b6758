#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track {
namespace {

using testing::ElementsAre;

constexpr double golden = 0.6180339887498949;
constexpr double root_of_two = 0.4142135623730950;

/// A scene of which every constant is far from zero, and one with nothing but zeros where it may.
Scene full_scene() {
  Scene scene;
  scene.mass = 1.5;
  scene.wall_lower = 0.5;
  scene.wall_upper = 2.0;
  scene.restitution_lower = 0.25;
  scene.restitution_upper = 0.5;
  scene.friction = 0.125;
  scene.normal_force = 3.0;
  scene.pull = -1.25;
  scene.pull_phase = 3.5;
  scene.centrifugal_mass_radius = 0.75;
  scene.slider_mass_radius = 0.375;
  scene.phase = 0.25;
  scene.disturbance = 2.5;
  scene.disturbance_frequency = 7.0;
  scene.disturbance_phase = -0.5;
  scene.start_position = 1.0;
  scene.start_velocity = -3.0;
  scene.omega = 5.0;
  scene.profile = {{0.0, 4.0}, {1.0, 6.0}};
  scene.stiffness = 1e7;
  scene.contact_speed = 0.625;
  scene.across = Across<double>{1.75, -1.0, 3.0, 0.75, 0.625, 2.0, 0.875};
  return scene;
}

/// The constants that a perturbation changes, in the order in which it does, and what their change
/// is relative to.
std::vector<std::pair<double, double>> drawn(const Scene& s) {
  const Across<double>& y = s.across.value();
  const auto own = [](double x) { return std::pair(x, x); };
  return {own(s.mass),
          {s.wall_lower, 2.0},  // the largest coordinate
          {s.wall_upper, 2.0},
          {s.start_position, 2.0},
          own(s.restitution_lower),
          own(s.restitution_upper),
          own(s.friction),
          own(s.normal_force),
          own(s.pull),
          own(s.centrifugal_mass_radius),
          own(s.slider_mass_radius),
          {s.phase, 1.0},  // a radian
          own(s.disturbance),
          own(s.disturbance_frequency),
          own(s.start_velocity),
          own(s.omega),
          own(s.profile[0].omega),
          own(s.profile[1].omega),
          own(s.stiffness),
          own(s.contact_speed.value()),
          own(y.pull),
          {y.wall_lower, 3.0},
          {y.wall_upper, 3.0},
          {y.start_position, 3.0},
          own(y.restitution_lower),
          own(y.restitution_upper),
          own(y.start_velocity),
          {s.pull_phase, 3.5},
          {s.disturbance_phase, 1.0}};
}

/// Counts of scenes on record were judged with these very changes.
TEST(Perturbation, DrawsItsChangesInAFixedOrder) {
  const Scene scene = full_scene();
  const auto given = drawn(scene);
  for (const double stride : {golden, root_of_two}) {
    for (const double sign : {1.0, -1.0}) {
      const auto changed = drawn(perturbed(scene, stride, sign));
      for (std::size_t i = 0; i < given.size(); ++i) {
        const double share = std::fmod(stride * static_cast<double>(i + 1), 1.0);
        const double weight = share < 0.5 ? share - 1 : share;  // of 0.5 to 1 either way
        EXPECT_NEAR((changed[i].first - given[i].first) / given[i].second,
                    sign * weight * perturbation_size, 1e-6 * perturbation_size)
            << i;
      }
    }
  }
}

TEST(Perturbation, KeepsWhatTheCountIsJudgedBy) {
  const Scene scene = full_scene();
  const Scene near = perturbed(scene, golden, 1.0);
  EXPECT_EQ(near.counting_limit, scene.counting_limit);
  EXPECT_EQ(near.peak_high, scene.peak_high);
  EXPECT_EQ(near.peak_low, scene.peak_low);
  EXPECT_EQ(near.contact_exponent, scene.contact_exponent);
  EXPECT_EQ(std::get<Seconds>(near.window).count, std::get<Seconds>(scene.window).count);
  EXPECT_EQ(near.profile[1].time, scene.profile[1].time);
}

TEST(Perturbation, KeepsZerosElasticWallsAndABodyOnAWall) {
  Scene scene;  // nearly all zeros
  scene.wall_lower = -1;
  scene.start_position = -1;
  for (const double sign : {1.0, -1.0}) {
    const Scene near = perturbed(scene, golden, sign);
    EXPECT_NE(near.mass, scene.mass);
    for (const double zero :
         {near.friction, near.normal_force, near.pull, near.centrifugal_mass_radius,
          near.slider_mass_radius, near.disturbance, near.start_velocity}) {
      EXPECT_EQ(zero, 0);
    }
    EXPECT_LE(near.restitution_lower, 1);
    EXPECT_LE(near.restitution_upper, 1);
    EXPECT_NE(near.wall_lower, scene.wall_lower);
    EXPECT_EQ(near.start_position, near.wall_lower);
    scene.wall_upper = std::numeric_limits<double>::infinity();
    EXPECT_EQ(perturbed(scene, golden, sign).wall_upper, scene.wall_upper);
    scene.wall_upper = 1;
  }
}

TEST(Perturbation, OfAValidSceneIsValid) {
  RandomScenes scenes(17);
  for (int i = 0; i < 500; ++i) {
    for (const Scene& scene : {scenes.next(), scenes.next_planar()}) {
      EXPECT_NO_THROW(check(perturbed(scene, golden, 1.0), "scene"));
      EXPECT_NO_THROW(check(perturbed(scene, root_of_two, -1.0), "scene"));
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
