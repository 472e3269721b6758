#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/flight_method.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/impact_model.h"

namespace ricochet::carrier_track {
namespace {

/// Compares the forces with the accelerations of the flights that the impact model makes.
struct AccelerationWatch : Observer {
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
    AccelerationWatch watch;
    watch.forces = forces_of(scene);
    ImpactModel<double>(scene).run(watch);
    compared += watch.compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Forces, ChangeAtTheRateThatTheyTell) {
  RandomScenes scenes(4);
  for (int i = 0; i < 20; ++i) {
    const Forces forces = forces_of(scenes.next());
    const double h = 1e-6;
    const double slope = (forces.applied(0.3 + h) - forces.applied(0.3 - h)) / (2 * h);
    EXPECT_NEAR(forces.applied_rate(0.3), slope, 1e-6 * (1 + std::abs(slope)));
  }
}

TEST(Forces, HaveThePeriodOfTheFastestThatActs) {
  Forces forces;
  forces.omega = 5;
  forces.disturbance_frequency = 8;
  EXPECT_EQ(forces.shortest_period(), std::numeric_limits<double>::infinity());
  forces.turning = 1;
  EXPECT_DOUBLE_EQ(forces.shortest_period(), 2 * std::numbers::pi / 5);
  forces.disturbance = 1;
  EXPECT_DOUBLE_EQ(forces.shortest_period(), 2 * std::numbers::pi / 8);
}

}  // namespace
}  // namespace ricochet::carrier_track
