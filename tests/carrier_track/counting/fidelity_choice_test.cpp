#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/watch.h"

namespace ricochet::carrier_track {
namespace {

/// A bouncing ball whose second impact, at half the speed of the first, is about the limit.
Scene ball(double excess) {
  Scene scene;
  scene.wall_upper = 10;
  scene.restitution_lower = 0.5;
  scene.pull = 9.8;
  scene.start_position = 1;
  scene.window = Seconds{1.2};
  scene.counting_limit = 0.5 * std::sqrt(2 * 9.8) * (1 - excess);
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = 1e8;
  scene.fidelity = Fidelity::automatic;
  return scene;
}

TEST(Level, IsImpactWhereItsCountIsCertain) {
  EXPECT_EQ(needed_fidelity(ball(1e-3)), Fidelity::impact);
  EXPECT_EQ(record(ball(1e-3), default_smoothing, 0).fidelity, Fidelity::impact);
  EXPECT_EQ(record(ball(1e-3), default_smoothing, 0).count, 2);
}

TEST(Level, IsCompliantWhereHardWallsLeaveTheCountOpenAndItSettlesIt) {
  Scene hard = ball(1e-13);
  hard.fidelity = Fidelity::impact;
  ASSERT_FALSE(record(hard, default_smoothing, 0).certainty.certain);
  const Recording recording = record(ball(1e-13), default_smoothing, 0);
  EXPECT_EQ(recording.fidelity, Fidelity::compliant);
  EXPECT_TRUE(recording.certainty.certain);
  // Pressed by its weight, the ball loses in a wall that gives way a little more or less.
  Scene soft = ball(1e-13);
  soft.fidelity = Fidelity::compliant;
  EXPECT_EQ(recording.count, record(soft, default_smoothing, 0).count);
  EXPECT_EQ(objective(ball(1e-13), 0.0), recording.count);
}

TEST(Level, IsImpactWhereNoLevelIsCertain) {
  // Chaos: a shaken gap with a pull, long enough for any digit to matter.
  Scene scene;
  scene.wall_upper = 0.6e-3;
  scene.restitution_lower = scene.restitution_upper = 0.8;
  scene.disturbance = 0.79;
  scene.pull = 0.39;
  scene.disturbance_frequency = 62.8;
  scene.start_position = 0.3e-3;
  scene.start_velocity = 0.03;
  scene.window = Seconds{30};
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = 1e12;
  EXPECT_EQ(needed_fidelity(scene), Fidelity::impact);
  scene.fidelity = Fidelity::automatic;
  EXPECT_FALSE(record(scene, default_smoothing, 0).certainty.certain);
}

TEST(Level, IsPlanarWhereTheSecondDirectionActs) {
  Scene scene = ball(1e-3);
  scene.friction = 0.2;
  scene.normal_force = 1;
  scene.across.emplace();
  scene.across->pull = 0.1;
  EXPECT_FALSE(couples(scene)) << "friction holds it, with up to 0.2 N";
  EXPECT_EQ(needed_fidelity(scene), Fidelity::impact);
  scene.across->pull = 0.3;
  EXPECT_TRUE(couples(scene));
  EXPECT_EQ(needed_fidelity(scene), Fidelity::planar);
  EXPECT_EQ(record(scene, default_smoothing, 0).fidelity, Fidelity::planar);
  scene.friction = 0;
  EXPECT_FALSE(couples(scene)) << "without friction nothing is handed on";
}

TEST(Level, NeverLeavesOutASecondDirectionThatMatters) {
  RandomScenes scenes(61);
  int alone = 0;
  for (int i = 0; i < 1000; ++i) {
    Scene scene = scenes.next_planar();
    scene.across->pull *= 0.5;
    if (scenes.chance(0.5)) scene.across->start_velocity = 0;
    if (couples(scene)) continue;
    ++alone;
    const auto both = watch(scene);
    scene.fidelity = Fidelity::impact;
    const auto one = watch(scene);
    ASSERT_EQ(both.hits.size(), one.hits.size());
    for (std::size_t k = 0; k < one.hits.size(); ++k) {
      EXPECT_EQ(both.hits[k].speed, one.hits[k].speed);
    }
  }
  EXPECT_GT(alone, 100);
}

TEST(Level, IsThatOfTheSceneUnlessLeftOpen) {
  for (const Fidelity level : {Fidelity::impact, Fidelity::compliant}) {
    Scene scene = ball(1e-13);
    scene.fidelity = level;
    EXPECT_EQ(resolve_fidelity(scene).fidelity, level);
  }
}

TEST(Level, IsChosenAnewForEverySceneThatLeavesItOpen) {
  for (const double excess : {1e-3, 1e-13}) {
    Watched<double> open, fixed;
    simulate_at_needed_fidelity(ball(excess), open);
    Scene scene = ball(excess);
    scene.fidelity = needed_fidelity(scene);
    simulate(scene, fixed);
    ASSERT_EQ(open.hits.size(), fixed.hits.size());
    for (std::size_t k = 0; k < fixed.hits.size(); ++k) {
      EXPECT_EQ(open.hits[k].time, fixed.hits[k].time);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
