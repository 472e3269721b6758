#include <gtest/gtest.h>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "src/studies/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {
namespace {

using namespace carrier_track;

TEST(Truth, IsTheClosedFormOfABouncingBall) {
  const double e = 0.7, gravity = 9.81, height = 2;
  TestScene scene;
  scene.mass = 3;
  scene.restitution_lower = e;
  scene.position = height;
  scene.duration = 4;
  scene.slowest = 0.01;
  scene.force = {{0, {{{-3 * gravity, 0, 0}, {}}}}};
  Random random(1);
  const auto known = conditioned_truth(scene, random);
  ASSERT_TRUE(known);
  const double first = std::sqrt(2 * height / gravity);
  ASSERT_GT(known->impacts.size(), 15U);
  for (std::size_t k = 0; k < known->impacts.size(); ++k) {
    const double power = std::pow(e, k);
    const TrueImpact& impact = known->impacts[k];
    EXPECT_NEAR(impact.time, first * (1 + e - 2 * e * power) / (1 - e), 1e-14);
    EXPECT_NEAR(impact.speed, gravity * first * power, 1e-13);
    EXPECT_EQ(impact.wall, Wall::lower);
    EXPECT_GT(impact.time_sensitivity, 0);
  }
  // The first fall takes sqrt(2 h m / F): it changes by 3 / 2 of a change of all at most.
  EXPECT_LE(known->impacts.front().time_sensitivity, 1.5 * first);
  EXPECT_GT(known->impacts.back().speed, 0.005);
}

TEST(Truth, IsThatOfTheOracleInClosedForm) {
  RandomScenes scenes(5);
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    Scene machine = scenes.next();
    machine.contact_friction = false;
    machine.rule = CountRule::impacts;
    const OracleRun closed = oracle_run(machine);
    const auto impacts = exact_impacts(test_scene(machine));
    ASSERT_EQ(impacts.has_value(), closed.finished);
    if (!impacts) continue;
    std::size_t next = 0;
    for (const Impact& i : closed.impacts) {
      if (i.speed <= machine.counting_limit / 2) continue;
      ASSERT_LT(next, impacts->size()) << k;
      const Impact& own = (*impacts)[next++];
      EXPECT_EQ(own.wall, i.wall);
      EXPECT_NEAR(own.time, i.time, 1e-11) << k;
      ++compared;
    }
    EXPECT_EQ(next, impacts->size()) << k;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Truth, EndsWhereAnImpactIsBarelyThere) {
  // The path touches the upper wall, or just does not, by 1e-13 of the clearance.
  TestScene scene;
  scene.upper = 1;
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.duration = 20;
  scene.slowest = 1e-9;
  scene.force = {{0, {{{-1, 0, 0}, {}}}}};
  for (const double by : {1e-13, -1e-13}) {
    scene.velocity = std::sqrt(2.0) * (1 + by);
    Random random(1);
    const auto known = conditioned_truth(scene, random);
    ASSERT_TRUE(known);
    EXPECT_TRUE(known->impacts.empty());
    EXPECT_NEAR(known->good_until, (by > 0 ? 1 : 2) * std::sqrt(2.0), 1e-5);
  }
}

}  // namespace
}  // namespace ricochet::studies::impact_test
