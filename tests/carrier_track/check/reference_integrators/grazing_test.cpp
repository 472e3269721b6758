#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

/// What the methods make of a carrier that just touches a wall, and of rests that hardly end or
/// begin: documentation of where they fail as much as a test.
namespace ricochet::carrier_track {
namespace {

/// Thrown at the upper wall, which its arc under pull and a harmonic overshoots by `depth` [m], if
/// negative misses. Without friction; the summit comes from the closed-form flight.
Scene touch(double depth) {
  Scene scene;
  scene.pull = 1.0;
  scene.omega = 100.0;
  scene.centrifugal_mass_radius = 1.0 / (scene.omega * scene.omega);
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.start_position = 0.5e-3;
  scene.start_velocity = 0.02;
  scene.window = Seconds{0.03};
  scene.wall_upper = infinity;
  scene.wall_upper = record(scene, 0.1, 0).peaks.at(0).position - depth;
  return scene;
}

bool touches(const Integrator& integrator, double depth, double control) {
  const Outcome outcome = run(integrator, touch(depth), control);
  return !outcome.impacts.empty() && outcome.impacts[0].wall == Wall::upper;
}

TEST(Grazing, EventDrivenFindsATouchDownToRoundingAndNothingShortOfIt) {
  const Integrator integrator = find_integrator("event-driven");
  for (const double depth : {1e-6, 1e-9, 1e-12, 1e-15}) {
    EXPECT_TRUE(touches(integrator, depth, 0)) << depth;
    EXPECT_FALSE(touches(integrator, -depth, 0)) << depth;
  }
}

TEST(Grazing, SignChangesFindATouchOnlyIfItIsDeeperThanTheTolerance) {
  // Relative to the gap of 0.9 mm, the depth is 1e-3 and 1e-7.
  for (const Integrator& integrator : integrators_by("relative tolerance")) {
    for (const double depth : {1e-6, 1e-10}) {
      EXPECT_TRUE(touches(integrator, depth, 1e-11)) << integrator.name << " " << depth;
      EXPECT_FALSE(touches(integrator, -depth, 1e-11)) << integrator.name << " " << depth;
    }
    const bool certain = touches(integrator, 1e-10, 1e-4) && !touches(integrator, -1e-10, 1e-4);
    EXPECT_FALSE(certain) << integrator.name;
  }
}

TEST(Grazing, FixedStepsMissATouchThatFallsBetweenTwoOfThem) {
  // The overshoot of 1e-9 m lasts 5e-5 s.
  for (const Integrator& integrator : integrators_by("step [s]")) {
    const bool certain = touches(integrator, 1e-9, 1e-3) && !touches(integrator, -1e-9, 1e-3);
    EXPECT_FALSE(certain) << integrator.name;
  }
}

TEST(Grazing, SampledDeparturesMissAForceThatExceedsFrictionForAMoment) {
  // The force is friction / 0.99999 cos(omega t - 0.05) and exceeds friction while the angle is
  // within 0.0045 of 0.05, between the samples at 0 and 2 pi / 64.
  Scene scene = block();
  scene.omega = 3.0;
  scene.centrifugal_mass_radius = block_friction * scene.mass / 0.99999 / 9.0;
  scene.phase = -0.05;
  scene.window = Seconds{0.5};
  EXPECT_GT(reference(scene).end.position, 0.0);
  for (const Integrator& integrator : integrators_by("relative tolerance")) {
    EXPECT_EQ(run(integrator, scene, 1e-10).end.position, 0.0) << integrator.name;
  }
}

TEST(Zeno, EndsInRest) {
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == by_depth) continue;  // it rests in the floor
    const bool fixed = integrator.setting == "step [s]";
    const Outcome outcome = run(integrator, bouncing_ball(), fixed ? 1e-3 : 1e-8);
    EXPECT_LT(outcome.impacts.size(), 200U) << integrator.name;
    EXPECT_LT(outcome.impacts.back().time, 29.0) << integrator.name;
    EXPECT_EQ(outcome.end.velocity, 0.0) << integrator.name;
    // Moreau-Jean leaves a body a little inside the floor.
    EXPECT_NEAR(outcome.end.position, 0.0, integrator.name == "moreau-jean" ? 1e-5 : 0.0)
        << integrator.name;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
