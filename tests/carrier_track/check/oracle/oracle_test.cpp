#include "problems/carrier_track/check/oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

constexpr double rounding = 4e-16;  // of a double, and of the few operations of a closed form

Scene falling(double height, double gravity, double restitution) {
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.start_position = height;
  scene.pull = gravity;
  scene.restitution_lower = restitution;
  return scene;
}

TEST(Oracle, BouncesABallAtTheTimesOfTheGeometricSeries) {
  const long double e = 0.8;
  Scene scene = falling(50, 9.8, 0.8);
  scene.window = Seconds{40};
  const OracleRun run = oracle_run(scene);
  ASSERT_TRUE(run.finished);
  const long double first = std::sqrt(2 * 50 / static_cast<long double>(9.8));
  const long double speed = 9.8 * first;
  int expected_count = 0;
  ASSERT_GT(run.impacts.size(), 60U);
  for (std::size_t k = 0; k < run.impacts.size(); ++k) {
    const long double power = std::pow(e, static_cast<long double>(k));
    const long double time = first * (1 + e - 2 * e * power) / (1 - e);
    expected_count += speed * power > scene.counting_limit;
    EXPECT_NEAR(static_cast<double>(run.impacts[k].time / time - 1), 0, rounding);
    EXPECT_NEAR(static_cast<double>(run.impacts[k].speed / (speed * power) - 1), 0, rounding);
  }
  EXPECT_EQ(run.count, expected_count);
}

TEST(Oracle, CountsTheMaximaOfABouncingBallOrSaysThatTheyNeverEnd) {
  Scene scene = falling(0, 10, 0.5);
  scene.rule = CountRule::peaks;
  scene.start_velocity = 10;  // up to 5 m, and a quarter as high each time
  scene.peak_high = 0.01;
  scene.peak_low = 1e-300;
  scene.window = Seconds{3.99};  // of 4
  const OracleRun counted = oracle_run(scene);
  EXPECT_EQ(counted.count, 5);  // 5, 1.25, 0.31, 0.078, 0.0195
  for (std::size_t k = 0; k < counted.maxima.size(); ++k) {
    const double height = 5 * std::pow(0.25, k);
    EXPECT_NEAR(counted.maxima[k].position / height, 1, rounding);
  }
  EXPECT_FALSE(counted.endless);
  scene.window = Seconds{5};
  EXPECT_TRUE(oracle_run(scene).endless);
  // Between the limits none counts.
  scene.wall_lower = scene.start_position = 0.001;
  EXPECT_FALSE(oracle_run(scene).endless);
  EXPECT_EQ(oracle_run(scene).count, 5);
}

TEST(Oracle, CountsAStayOnTheUpperWallOnce) {
  // Thrown to a ceiling without rebound, on which x'' = sin t holds it from 0 to pi.
  Scene scene;
  scene.rule = CountRule::peaks;
  scene.centrifugal_mass_radius = 1;
  scene.phase = -std::numbers::pi / 2;
  scene.start_velocity = 1;
  scene.restitution_upper = 0;
  scene.peak_high = 0.9;
  scene.window = Seconds{3.1};
  EXPECT_EQ(oracle_run(scene).count, 0) << "it is still there";
  scene.window = Seconds{3.5};
  EXPECT_EQ(oracle_run(scene).count, 1);
  EXPECT_EQ(oracle_run(scene).maxima.front().position, 1.0);
}

TEST(Oracle, SlowsADropByFriction) {
  const long double fall = 9.0;  // gravity less friction, then gravity and friction
  const long double rise = 11.0;
  Scene scene = falling(1, 10, 0.5);
  scene.friction = 0.5;
  scene.normal_force = 2;
  scene.window = Seconds{2};
  const OracleRun run = oracle_run(scene);
  long double time = std::sqrt(2 / fall);
  long double speed = fall * time;
  ASSERT_GT(run.impacts.size(), 10U);
  for (const Impact& impact : run.impacts) {
    EXPECT_NEAR(static_cast<double>(impact.time / time - 1), 0, rounding);
    EXPECT_NEAR(static_cast<double>(impact.speed / speed - 1), 0, rounding);
    const long double rebound = speed / 2;
    speed = rebound * std::sqrt(fall / rise);
    time += rebound / rise + speed / fall;
  }
}

TEST(Oracle, KeepsTheSymmetricOrbitBetweenTwoShakenWalls) {
  // Seen from the walls x'' = cos(t + phase). A body that leaves the lower wall at e v arrives
  // after half a period at v, and then the same in the mirror, if speed and gap are these.
  const double e = 0.5;
  Scene scene;
  scene.phase = 0.5 - std::numbers::pi;  // the stable one of the two orbits
  scene.centrifugal_mass_radius = 1;
  scene.restitution_lower = scene.restitution_upper = e;
  const double speed = -2 * std::sin(scene.phase) / (1 - e);
  scene.start_position = 0;
  scene.start_velocity = e * speed;
  scene.wall_upper = std::numbers::pi * e * speed + 2 * std::cos(scene.phase) -
                     std::numbers::pi * std::sin(scene.phase);
  scene.window = Seconds{20.5 * std::numbers::pi};
  const OracleRun run = oracle_run(scene);
  ASSERT_EQ(run.impacts.size(), 20U);
  for (std::size_t k = 0; k < run.impacts.size(); ++k) {
    EXPECT_EQ(run.impacts[k].wall, k % 2 == 0 ? Wall::upper : Wall::lower);
    EXPECT_NEAR(run.impacts[k].time, static_cast<double>(k + 1) * std::numbers::pi, 3e-14);
    EXPECT_NEAR(run.impacts[k].speed, speed, 1e-14);
  }
}

TEST(Oracle, ReleasesABodyWhenItsForceExceedsFriction) {
  // x'' = sin(t) - 0.3 from t0 = asin(0.3) on, in closed form at the time where it comes to rest.
  Scene scene;
  scene.centrifugal_mass_radius = 1;
  scene.phase = -std::numbers::pi / 2;
  scene.friction = 0.3;
  scene.normal_force = 1;
  scene.start_position = 0;
  scene.wall_upper = 10;
  scene.window = Seconds{6};
  const OracleRun run = oracle_run(scene);
  ASSERT_EQ(run.summits.size(), 1U);
  const long double t0 = std::asin(static_cast<long double>(0.3));
  const long double t = run.summits[0].time;
  const long double friction = 0.3;
  EXPECT_NEAR(static_cast<double>(std::cos(t0) - std::cos(t) - friction * (t - t0)), 0, 2e-15);
  const long double height =
      std::cos(t0) * (t - t0) - (std::sin(t) - std::sin(t0)) - friction * (t - t0) * (t - t0) / 2;
  EXPECT_NEAR(static_cast<double>(run.summits[0].height - height), 0, rounding);
}

TEST(Oracle, NeverReleasesABodyHeldAtTheVeryLimit) {
  Scene scene;
  scene.disturbance = 1;
  scene.friction = 1;
  scene.window = Seconds{100};
  scene.start_position = 0;
  scene.wall_upper = 1e-30;  // what moves at all strikes
  scene.normal_force = 1;
  EXPECT_TRUE(oracle_run(scene).impacts.empty());
  scene.normal_force = 1 - 1e-12;
  EXPECT_FALSE(oracle_run(scene).impacts.empty());
}

TEST(Oracle, DecidesAGrazingInTheLastDigitOfTheWall) {
  Scene scene = falling(0, 0.5, 0.5);
  scene.start_velocity = 1;  // summit at exactly 1 m
  scene.window = Seconds{3};
  scene.wall_upper = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(oracle_run(scene).impacts.empty());
  scene.wall_upper = std::nextafter(1.0, 0.0);
  const OracleRun run = oracle_run(scene);
  ASSERT_EQ(run.impacts.size(), 1U);
  EXPECT_NEAR(run.impacts[0].speed / std::sqrt(1 - scene.wall_upper), 1, 1e-3);
}

TEST(Oracle, SaysWhereItBreaksOff) {
  Scene scene;  // elastic, to and fro
  scene.start_velocity = 1;
  scene.window = Seconds{1e4};
  const OracleRun run = oracle_run(scene);
  EXPECT_FALSE(run.finished);
  EXPECT_EQ(run.impacts.size(), oracle_impact_cap);
}

}  // namespace
}  // namespace ricochet::carrier_track
