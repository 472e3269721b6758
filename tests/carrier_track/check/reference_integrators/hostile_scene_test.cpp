#include <gmock/gmock.h>

#include <cmath>

#include "problems/carrier_track/motion/impact_model.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

/// Every method has to end, with the end of the window or with a reason.
namespace ricochet::carrier_track {
namespace {

void expect_ends(const Scene& scene, double tolerance, double step) {
  for (const Integrator& integrator : all_integrators()) {
    const bool fixed = integrator.setting == "step [s]";
    const bool springs = integrator.setting == by_depth;
    const Outcome outcome = integrator.run(scene, fixed ? step : springs ? 1e-3 : tolerance);
    EXPECT_NE(outcome.finished, !outcome.failure.empty()) << integrator.name;
    EXPECT_EQ(outcome.finished, outcome.failure.empty()) << integrator.name;
    EXPECT_TRUE(std::isfinite(outcome.end.position)) << integrator.name;
    EXPECT_TRUE(std::isfinite(outcome.end.velocity)) << integrator.name;
    EXPECT_LE(outcome.impacts.size(), most_impacts) << integrator.name;
    if (outcome.finished) {
      EXPECT_NEAR(outcome.end.time, duration_of(scene), 1e-12 * duration_of(scene))
          << integrator.name;
    }
  }
}

TEST(HostileScene, WithPlasticOrElasticWallsIsFinished) {
  for (const double restitution : {0.0, 1.0}) {
    for (const double friction : {0.0, 0.2}) {
      Scene scene = paper_scene("C2", 7.0);
      scene.restitution_lower = scene.restitution_upper = restitution;
      scene.friction = friction;
      for (const Integrator& integrator : all_integrators()) {
        run(integrator, scene, integrator.setting == by_depth ? 1e-3 : 1e-5);
      }
    }
  }
}

TEST(HostileScene, WithoutForcesIsFinished) {
  Scene scene;
  for (const double velocity : {0.0, -3.0}) {
    scene.start_velocity = velocity;
    for (const Integrator& integrator : all_integrators()) {
      if (integrator.setting == by_depth) continue;  // at 1e-6 it takes too many steps
      const Outcome outcome = run(integrator, scene, 1e-6);
      EXPECT_EQ(outcome.impacts.size(), velocity == 0.0 ? 0U : 3U) << integrator.name;
    }
  }
}

TEST(HostileScene, ThatStartsOnAWallStrikesOrRestsAtOnce) {
  Scene scene;
  scene.restitution_lower = 0.5;
  scene.pull = 1.0;
  scene.start_position = 0.0;
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == by_depth) continue;  // it starts in the wall
    scene.start_velocity = -0.2;
    const double step = 1e-5;
    const Outcome struck = run(integrator, scene, step);
    ASSERT_FALSE(struck.impacts.empty()) << integrator.name;
    EXPECT_NEAR(struck.impacts[0].time, 0.0, step) << integrator.name;
    EXPECT_NEAR(struck.impacts[0].speed, 0.2, 2 * step) << integrator.name;
    scene.start_velocity = 0.0;
    const Outcome resting = run(integrator, scene, step);
    EXPECT_TRUE(resting.impacts.empty()) << integrator.name;
    EXPECT_EQ(resting.end.position, 0.0) << integrator.name;
  }
}

TEST(HostileScene, WithAVeryFastDriverEnds) {
  Scene scene = paper_scene("C4", 1e6);
  expect_ends(scene, 1e-6, 1e-10);
  scene.window = Seconds{5e-4};  // 80 turns
  expect_ends(scene, 1e-6, 1e-7);
  scene.pull = 0;  // and at rest from the start
  scene.centrifugal_mass_radius = 0;
  scene.disturbance = 1e-3;
  scene.disturbance_frequency = 1e9;
  scene.start_velocity = 0;
  expect_ends(scene, 1e-6, 1e-6);
}

TEST(HostileScene, WithMoreThanAMillionImpactsIsGivenUp) {
  Scene scene;
  scene.wall_upper = 1e-6;
  scene.start_position = 0.5e-6;
  scene.start_velocity = 1.0;
  scene.window = Seconds{10.0};
  for (const char* name : {"event-driven", "runge-kutta-4", "moreau-jean"}) {
    const Outcome outcome = find_integrator(name).run(scene, 1e-6);
    EXPECT_FALSE(outcome.finished) << name;
    EXPECT_EQ(outcome.failure, "more than 1000000 impacts") << name;
    EXPECT_EQ(outcome.impacts.size(), most_impacts) << name;
  }
}

TEST(HostileScene, WithMoreThanAMillionStepsIsGivenUp) {
  Scene scene;  // no wall is ever reached
  scene.disturbance = 1e6;
  scene.disturbance_frequency = 1e5;
  scene.window = Seconds{100.0};
  for (const char* name : {"odeint-dopri5", "cvode-adams"}) {
    const Outcome outcome = find_integrator(name).run(scene, 1e-6);
    EXPECT_FALSE(outcome.finished) << name;
    EXPECT_THAT(outcome.failure, testing::HasSubstr("more than 1000000 steps")) << name;
  }
}

TEST(HostileScene, WithAnImpossibleControlEnds) {
  expect_ends(paper_scene("C4", 5.0), 1e-30, 1e-12);
  for (const Integrator& integrator : integrators_by("step [s]")) {
    const Outcome outcome = integrator.run(paper_scene("C4", 5.0), 1e-12);
    EXPECT_FALSE(outcome.finished);
    EXPECT_NE(outcome.failure.find("more than 100000000 steps"), std::string::npos);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
