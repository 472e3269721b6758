#include "src/studies/impact_test/test_scene.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "src/studies/impact_test/smallest_scene.h"

namespace ricochet::studies::impact_test {
namespace {

using namespace carrier_track;

template <class Forces>
double force_of_ricochet(const Scene& machine, double time) {
  Forces forces(machine);
  forces.pass(time);
  return machine.mass * forces.sum();
}

TEST(TestScene, HasTheForceOfTheSimulator) {
  int profiles = 0;
  for (int k = 0; k < 132; ++k) {
    const ScoredScene drawn = drawn_scene(3, k);
    const Scene& machine = drawn.machine;
    profiles += machine.profile.empty() ? 0 : 1;
    for (const double share : {0.01, 0.2, 0.37, 0.73, 0.99}) {
      const double time = share * drawn.scene.duration;
      const double expected = machine.profile.empty()
                                  ? force_of_ricochet<AppliedForces<double>>(machine, time)
                                  : force_of_ricochet<ProfileForces<double>>(machine, time);
      const double scale = std::abs(machine.pull) + std::abs(machine.disturbance) + 1;
      EXPECT_NEAR(force_at(drawn.scene, time), expected, 1e-11 * scale) << drawn.scene.scene;
    }
  }
  EXPECT_EQ(profiles, 12);
}

TEST(TestScene, KnowsAllForcesOfAProfile) {
  Scene machine;
  machine.mass = 2;
  machine.pull = 0.7;
  machine.pull_rotates = true;
  machine.pull_phase = 0.4;
  machine.slider_mass_radius = 0.3;
  machine.centrifugal_mass_radius = 0.2;
  machine.phase = 1;
  machine.disturbance = 0.5;
  machine.disturbance_frequency = 7;
  machine.profile = {{0.5, 2}, {1.5, 4}};
  machine.window = Seconds{2};
  // alpha = 1 + 2 t, then + (t - 0.5)^2, omega = 2 + 2 (t - 0.5), omega' = 2.
  const double t = 1.25, omega = 3.5, alpha = 1 + 2 * t + 0.75 * 0.75;
  for (const auto& [rule, centrifugal] :
       {std::pair{Centrifugal::projected, std::cos(alpha)}, std::pair{Centrifugal::inward, -1.0},
        std::pair{Centrifugal::outward, 1.0}}) {
    machine.centrifugal = rule;
    const double expected = -0.7 * std::cos(alpha + 0.4) + 0.2 * omega * omega * centrifugal -
                            0.3 * (2 * std::sin(alpha) + omega * omega * std::cos(alpha)) +
                            0.5 * std::cos(7 * t);
    EXPECT_NEAR(force_at(test_scene(machine), t), expected, 1e-14);
  }
}

}  // namespace
}  // namespace ricochet::studies::impact_test
