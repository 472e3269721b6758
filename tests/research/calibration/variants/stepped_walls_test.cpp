#include "src/research/calibration/variants/stepped_walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/contact_law.h"

namespace ricochet::studies::variants {
namespace {

using namespace carrier_track;

constexpr OdeTolerances exact_enough = {1e-8, 1e-11};

/// Bounces between elastic compliant walls, with no force.
Scene between_springs() {
  Scene scene;
  scene.mass = 1.2;
  scene.wall_upper = 2e-3;
  scene.start_position = 1e-3;
  scene.start_velocity = 0.1;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::hertz;
  scene.stiffness = 1e9;
  scene.counting_limit = 0.05;
  scene.window = Seconds{1};
  return scene;
}

TEST(SteppedWalls, SeeTheContactsOfAClosedFormulation) {
  const Scene scene = between_springs();
  const double depth = peak_penetration(scene.stiffness, 1.5, scene.mass, 0.1, 0);
  const double contact = 2.943275 * depth / 0.1;  // Hertz: 2.9432 deepest / speed
  const double period = 2e-3 / 0.1 + contact;     // from one contact to the next
  for (const double window : {0.5, 1.0, 1.7}) {
    Scene there = scene;
    there.window = Seconds{window};
    const auto contacts = static_cast<int>((window - 1e-3 / 0.1) / period) + 1;
    EXPECT_EQ(stepped_count(there, exact_enough, 1000), contacts) << window;
  }
}

TEST(SteppedWalls, HaveTheCountsOfExactEventsAtTightTolerances) {
  std::mt19937_64 random(5);
  const auto within = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int differing = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = between_springs();
    scene.contact_law = ContactLaw::exact_restitution;
    scene.restitution_lower = scene.restitution_upper = within(0.3, 0.9);
    scene.friction = i % 2 == 0 ? 0.0 : 0.2;
    scene.normal_force = 2;
    scene.centrifugal_mass_radius = 0.3;
    scene.omega = within(2, 12);
    scene.start_velocity = within(-0.2, 0.2);
    scene.window = Revolutions{1};
    scene.counting_limit = 0.02;
    const int exact = count_at(scene, scene.omega);
    const int stepped = stepped_count(scene, exact_enough, 1000);
    EXPECT_LE(std::abs(stepped - exact), 2) << i;
    differing += stepped != exact ? 1 : 0;
  }
  EXPECT_LE(differing, 6) << "friction that rises smoothly, and impacts next to the limit";
}

TEST(SteppedWalls, TakeCountsThatAreOfNoInterestForOneMore) {
  EXPECT_EQ(stepped_count(between_springs(), {}, 7), 8);
}

TEST(SteppedWalls, MissWhatBeginsAndEndsWithinAStep) {
  Scene scene = between_springs();  // thrown up, it dips 1 micrometre into the upper wall
  scene.pull = scene.mass * 4;
  scene.start_position = 0;
  scene.start_velocity = std::sqrt(2 * 4 * (scene.wall_upper + 1e-6));
  scene.counting_limit = 1e-4;
  scene.window = Seconds{1.83 * scene.start_velocity / 4};
  EXPECT_EQ(count_at(scene, 1), 1);
  EXPECT_EQ(stepped_count(scene, {}, 1000), 0);
  EXPECT_EQ(stepped_count(scene, exact_enough, 1000), 0) << "a parabola has no error at any step";
}

}  // namespace
}  // namespace ricochet::studies::variants
