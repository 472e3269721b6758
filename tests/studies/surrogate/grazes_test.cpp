#include "src/studies/surrogate/grazes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::Revolutions;
using carrier_track::Scene;
using carrier_track::Wall;

/// Drifts from x = 0.5 m at 0.1 m/s and swings by 0.5 m about that, so that it first turns at some
/// 1.5 m + 0.1 m/s pi / omega: the faster, the lower. The second swing hits the wall in any case.
Scene swing() {
  Scene scene;
  scene.centrifugal_mass_radius = 0.5;
  scene.start_position = 0.5;
  scene.start_velocity = 0.1;
  scene.wall_upper = 1.6;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.counting_limit = 0.01;
  scene.window = Revolutions{2};
  return scene;
}

/// [m] of the swing's top over the wall at a speed [rad/s].
double overshoot(double omega) {
  // x = 0.5 + 0.1 t + 0.5 (1 - cos(omega t)), first at rest where sin(omega t) = -0.2 / omega.
  const double angle = std::numbers::pi + std::asin(0.2 / omega);
  return 0.5 + 0.1 * angle / omega + 0.5 * (1 - std::cos(angle)) - 1.6;
}

double grazing_speed() {
  double lower = 1;
  double upper = 10;
  while (upper - lower > 1e-14) {
    const double middle = 0.5 * (lower + upper);
    (overshoot(middle) > 0 ? lower : upper) = middle;
  }
  return lower;
}

TEST(Grazes, AreWhereASwingJustComesToTheWall) {
  const auto grazes = find_grazes(swing(), 3, 3.5, 1);
  ASSERT_EQ(grazes.size(), 1U);
  EXPECT_NEAR(grazes[0].omega, grazing_speed(), 1e-13);
  EXPECT_EQ(grazes[0].side, -1);
  EXPECT_EQ(grazes[0].wall, Wall::upper);
  const double angle = std::numbers::pi + std::asin(0.2 / grazing_speed());
  EXPECT_NEAR(grazes[0].time, angle / grazing_speed(), 1e-6);
}

TEST(Grazes, AreToldByTheReachOnBothSides) {
  const Scene scene = swing();
  const auto grazes = find_grazes(scene, 2, 5, 10);
  ASSERT_FALSE(grazes.empty());
  for (const Graze& graze : grazes) {
    for (const double distance : {1e-5, 1e-7, 1e-9}) {
      const Approach near = approach(scene, graze, 0.25, distance);
      EXPECT_NEAR(near.hit_reach / distance, 1, 1e-2);
      EXPECT_NEAR(near.missed_reach / distance, 1, 1e-2);
    }
  }
}

TEST(Grazes, MakeTheSlopeGrowWithTheInverseRootWhereTheWallIsHit) {
  const GrazeStudy study = study_grazes({100, 3, {0.25}, {1e-7, 1e-8, 1e-9, 1e-10, 1e-11}});
  int growing = 0;
  for (const GrazeRow& row : study.rows) {
    ASSERT_TRUE(row.exponents[0]) << row.id;
    // Where nothing follows that counts, the slopes of both sides come together, or stay apart.
    const double exponent = *row.exponents[0];
    EXPECT_NEAR(exponent, row.grows(0) ? -0.5 : std::round(exponent), 0.05) << row.id;
    EXPECT_LT(std::abs(exponent), 1.1) << row.id;
    growing += row.grows(0);
    const auto& near = row.approaches[0];
    EXPECT_NEAR(near.back().missed_slope, near.front().missed_slope,
                1e-2 * std::abs(near.front().missed_slope));
  }
  EXPECT_GT(growing, 3);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
