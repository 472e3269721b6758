#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "problems/carrier_track/check/method.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {
namespace {

Scene compliant(ContactLaw law, double exponent) {
  Scene scene;
  scene.mass = 0.8;
  scene.restitution_lower = 0.5;
  scene.restitution_upper = 0.7;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  scene.contact_exponent = exponent;
  scene.stiffness = 300;
  scene.contact_speed = 2;
  return scene;
}

TEST(WallForce, IsTheContactLawOverTheMass) {
  const WallForce wall = wall_force_of(compliant(ContactLaw::hunt_crossley, 1.5));
  // K d^n (1 + D d'/v0) / m, with D = 3 (1 - c) / 2: 0.75 below, 0.45 above.
  const double spring = 300 / 0.8 * std::pow(0.01, 1.5);
  EXPECT_NEAR(wall({-0.01, -1}), spring * (1 + 0.75 / 2), 1e-12);
  EXPECT_NEAR(wall({-0.01, +1}), spring * (1 - 0.75 / 2), 1e-12);
  EXPECT_NEAR(wall({1.01, +1}), -spring * (1 + 0.45 / 2), 1e-12);
  EXPECT_EQ(wall({0.5, 3}), 0);
  EXPECT_EQ(wall({0, -3}), 0);
}

TEST(WallForce, OfKelvinAndVoigtNeverPulls) {
  const WallForce wall = wall_force_of(compliant(ContactLaw::kelvin_voigt, 1));
  const double damping = 2 * damping_ratio(0.5, Release::zero_force) * std::sqrt(300 / 0.8);  // C/m
  EXPECT_NEAR(wall({-0.01, -1}), 300 / 0.8 * 0.01 + damping, 1e-12);
  EXPECT_GT(damping, 300 / 0.8 * 0.01);
  EXPECT_EQ(wall({-0.01, +1}), 0);
}

TEST(WallForce, PullsWhereItMay) {
  WallForce wall = wall_force_of(compliant(ContactLaw::kelvin_voigt, 1));
  wall.pulls = true;
  EXPECT_NEAR(wall({-0.01, +1}), 300 / 0.8 * 0.01 - wall.lower_damping, 1e-12);
  EXPECT_EQ(wall.slopes({-0.01, +1}).by_velocity, -wall.lower_damping);
}

TEST(WallForce, HasTheSlopesOfItsDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> depth(0.01, 0.1), velocity(-1, 1);
  for (const double exponent : {1.0, 1.5, 2.2}) {
    for (const ContactLaw law : {ContactLaw::flores, ContactLaw::kelvin_voigt}) {
      const WallForce wall = wall_force_of(compliant(law, exponent));
      for (int i = 0; i < 40; ++i) {
        const double d = depth(random);
        const State s{i % 2 ? -d : 1 + d, velocity(random)};
        const double h = 1e-6;
        const auto slopes = wall.slopes(s);
        const double by_position =
            (wall({s.position + h, s.velocity}) - wall({s.position - h, s.velocity})) / (2 * h);
        const double by_velocity =
            (wall({s.position, s.velocity + h}) - wall({s.position, s.velocity - h})) / (2 * h);
        EXPECT_NEAR(slopes.by_position, by_position, 1e-5 * (1 + std::abs(by_position)));
        EXPECT_NEAR(slopes.by_velocity, by_velocity, 1e-5 * (1 + std::abs(by_velocity)));
      }
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
