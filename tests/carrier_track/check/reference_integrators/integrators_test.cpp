#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/accuracy.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(Integrators, AreListedOnceTheReferenceFirst) {
  std::vector<std::string> names;
  for (const Integrator& integrator : all_integrators()) {
    names.push_back(integrator.name);
    EXPECT_THAT(integrator.version, testing::ContainsRegex("[0-9]"));
  }
  EXPECT_THAT(names, testing::ElementsAre("event-driven", "odeint-dopri5", "odeint-rosenbrock4",
                                          "cvode-adams", "cvode-bdf", "semi-implicit-euler",
                                          "runge-kutta-4", "moreau-jean", "penalty"));
  EXPECT_EQ(integrators_by("relative tolerance").size(), 4U);
  EXPECT_EQ(integrators_by("step [s]").size(), 3U);
}

TEST(Integrators, WithLocatedEventsGiveTheBouncingBallItsClosedFormTimes) {
  for (const Integrator& integrator : integrators_by("relative tolerance")) {
    const Outcome outcome = run(integrator, bouncing_ball(), 1e-10);
    ASSERT_GE(outcome.impacts.size(), 20U) << integrator.name;
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(outcome.impacts[k].time, bounce_time(k), 1e-8 * bounce_time(k))
          << integrator.name << " " << k;
      EXPECT_EQ(outcome.impacts[k].wall, Wall::lower);
    }
    EXPECT_EQ(outcome.end.position, 0.0) << integrator.name;
    EXPECT_EQ(outcome.end.velocity, 0.0) << integrator.name;
    EXPECT_EQ(outcome.end.time, 40.0);
  }
}

TEST(Integrators, OfOneStepAreExactOnParabolasAtAnyTolerance) {
  for (const char* name : {"odeint-dopri5", "odeint-rosenbrock4"}) {
    const Outcome outcome = run(find_integrator(name), bouncing_ball(), 1e-2);
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(outcome.impacts.at(k).time, bounce_time(k), 1e-13 * bounce_time(k)) << name;
    }
  }
}

TEST(Integrators, StopASlidingBlockWhereFrictionHasUsedUpItsEnergy) {
  for (const double v0 : {0.1, -0.7}) {
    Scene scene = block();
    scene.start_velocity = v0;
    scene.window = Seconds{3.0};
    const double end = v0 * std::abs(v0) / (2 * block_friction);
    for (const Integrator& integrator : all_integrators()) {
      if (integrator.setting == by_depth) continue;  // friction lets it creep
      const bool fixed = integrator.setting == "step [s]";
      const Outcome outcome = run(integrator, scene, fixed ? 1e-4 : 1e-10);
      EXPECT_NEAR(outcome.end.position, end, fixed ? 1e-4 * std::abs(v0) : 1e-8) << integrator.name;
      EXPECT_EQ(outcome.end.velocity, 0.0) << integrator.name;
      EXPECT_TRUE(outcome.impacts.empty());
    }
  }
}

TEST(Integrators, HoldABlockAgainstAnyForceWithinItsFriction) {
  for (const double pull : {-0.4998, 0.0, 0.4998}) {
    Scene scene = block();
    scene.pull = pull;
    for (const Integrator& integrator : all_integrators()) {
      if (integrator.setting == by_depth) continue;
      const Outcome outcome = run(integrator, scene, 1e-3);
      EXPECT_EQ(outcome.end.position, 0.0) << integrator.name;
      EXPECT_EQ(outcome.end.velocity, 0.0) << integrator.name;
      EXPECT_EQ(outcome.end.time, 1.0) << integrator.name;
    }
  }
}

TEST(Integrators, LetABlockGoWhenTheForceExceedsItsFriction) {
  // The force 2 friction sin(omega t) exceeds friction from the angle pi/6 on.
  Scene scene = block();
  scene.omega = 3.0;
  scene.centrifugal_mass_radius = 2 * block_friction * scene.mass / 9.0;
  scene.phase = -std::numbers::pi / 2;
  const double departure = std::numbers::pi / 6 / scene.omega;
  const double later = departure + 0.1;
  const auto angle = [&](double t) { return scene.omega * t; };
  // Twice integrated: 2 f sin(omega t) - f from the departure on, f friction.
  const double w = scene.omega;
  const double f = block_friction;
  const double end = 2 * f / (w * w) * (std::sin(angle(departure)) - std::sin(angle(later))) +
                     2 * f / w * std::cos(angle(departure)) * 0.1 - f * 0.1 * 0.1 / 2;
  scene.window = Seconds{later};
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == by_depth) continue;
    const bool fixed = integrator.setting == "step [s]";
    const Outcome outcome = run(integrator, scene, fixed ? 1e-5 : 1e-12);
    EXPECT_NEAR(outcome.end.position, end, fixed ? 1e-3 * end : 1e-10) << integrator.name;
  }
}

TEST(Integrators, WithLocatedEventsAgreeWithTheEventDrivenOneOnRandomScenes) {
  RandomScenes scenes(7);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = scenes.next();
    const Outcome true_values = reference(scene);
    for (const Integrator& integrator : integrators_by("relative tolerance")) {
      const Accuracy accuracy = compare(scene, run(integrator, scene, 1e-10), true_values);
      EXPECT_EQ(accuracy.missed, 0) << integrator.name << " scene " << i;
      EXPECT_EQ(accuracy.spurious, 0) << integrator.name << " scene " << i;
      EXPECT_LT(accuracy.end_position_error, 1e-7) << integrator.name << " scene " << i;
    }
  }
}

TEST(Integrators, OfFixedStepAgreeOnAllButAFewRandomScenes) {
  RandomScenes scenes(8);
  constexpr int count = 60;
  std::vector<int> equal(integrators_by("step [s]").size(), 0);
  for (int i = 0; i < count; ++i) {
    const Scene scene = scenes.next();
    const Outcome true_values = reference(scene);
    std::size_t k = 0;
    for (const Integrator& integrator : integrators_by("step [s]")) {
      equal[k++] += compare(scene, run(integrator, scene, 1e-5), true_values).count_difference == 0;
    }
  }
  EXPECT_THAT(equal, testing::Each(testing::Ge(count * 9 / 10)));
}

TEST(Integrators, WithLocatedEventsReproduceTheCountsOfTheEventDrivenOne) {
  // The event-driven counts at 1, 2, 3, 5, 9, 13, 17 rad/s, as in the paper study.
  const std::vector<double> speeds = {1, 2, 3, 5, 9, 13, 17};
  const std::vector<std::pair<std::string, std::vector<int>>> expected = {
      {"C1", {1, 1, 3, 4, 4, 7, 7}}, {"C4", {5, 6, 11, 23, 47, 62, 69}}};
  std::vector<Integrator> integrators = integrators_by("relative tolerance");
  integrators.push_back(find_integrator("event-driven"));
  for (const auto& [id, counts] : expected) {
    for (const Integrator& integrator : integrators) {
      std::vector<int> found;
      for (const double speed : speeds) {
        const Scene scene = paper_scene(id, speed);
        found.push_back(collisions(scene, run(integrator, scene, 1e-10)));
      }
      EXPECT_EQ(found, counts) << integrator.name << " " << id;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
