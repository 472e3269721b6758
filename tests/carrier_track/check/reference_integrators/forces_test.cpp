#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/method.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/impact_model.h"

namespace ricochet::carrier_track {
namespace {

/// Compares the forces with the accelerations of the flights that the impact model makes.
struct AccelerationWatch : Observer {
  explicit AccelerationWatch(const Scene& scene) : forces(scene) {}

  Forces forces;
  int compared = 0;

  void stretch(double time, const Flight<double>& flight, double duration) {
    if (flight.harmonics == 0) return;  // at rest
    for (const double share : {0.0, 0.3, 1.0}) {
      const double expected = flight.at(share * duration).acceleration;
      EXPECT_NEAR(forces.applied(time + share * duration), expected,
                  1e-9 * (1 + std::abs(expected)));
      ++compared;
    }
  }
};

TEST(Forces, AreThoseOfTheImpactModel) {
  RandomScenes scenes(3);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    Scene scene = scenes.next();
    scene.friction = 0;  // a flight's acceleration would hold it
    AccelerationWatch watch(scene);
    ImpactModel<double>(scene).run(watch);
    compared += watch.compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Forces, ChangeAtTheRateThatTheyTell) {
  RandomScenes scenes(4);
  for (int i = 0; i < 20; ++i) {
    const Forces forces(scenes.next());
    const double h = 1e-6;
    const double slope = (forces.applied(0.3 + h) - forces.applied(0.3 - h)) / (2 * h);
    EXPECT_NEAR(forces.applied_rate(0.3, 0.3), slope, 1e-6 * (1 + std::abs(slope)));
  }
}

TEST(Forces, HaveThePeriodOfTheFastestThatActs) {
  Scene scene;
  scene.omega = 5;
  scene.disturbance_frequency = 8;
  EXPECT_EQ(Forces(scene).shortest_period(), std::numeric_limits<double>::infinity());
  scene.slider_mass_radius = 1;
  EXPECT_DOUBLE_EQ(Forces(scene).shortest_period(), 2 * std::numbers::pi / 5);
  scene.disturbance = 1;
  EXPECT_DOUBLE_EQ(Forces(scene).shortest_period(), 2 * std::numbers::pi / 8);
}

TEST(Forces, OfAProfileAreThoseOfEveryPieceContinuedBeyondItsEnds) {
  // omega = 2, then 2 + 2 (t - 0.5) until 1.5, then 4.
  Scene scene;
  scene.mass = 2;
  scene.slider_mass_radius = 0.3;
  scene.profile = {{0.5, 2}, {1.5, 4}};
  scene.window = Seconds{2};
  const Forces forces(scene);
  EXPECT_EQ(forces.smooth_until(0.2), 0.5);
  EXPECT_EQ(forces.smooth_until(0.5), 1.5);
  const auto force = [](double alpha, double omega, double slope) {
    return -0.15 * (slope * std::sin(alpha) + omega * omega * std::cos(alpha));
  };
  const double t = 1.25, u = t - 0.5;
  EXPECT_NEAR(forces.applied(t), force(2 * t + u * u, 2 + 2 * u, 2), 1e-14);
  EXPECT_NEAR(forces.applied(t, 0), force(2 * t, 2, 0), 1e-14);
  const double bound = 0.15 * (16 + 2);
  EXPECT_NEAR(forces.strongest(), bound, 1e-12);
  EXPECT_DOUBLE_EQ(forces.shortest_period(), 2 * std::numbers::pi / 4);
}

}  // namespace
}  // namespace ricochet::carrier_track
