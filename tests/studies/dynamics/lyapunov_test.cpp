#include "src/studies/dynamics/lyapunov.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {
namespace {

using carrier_track::Revolutions;
using carrier_track::Scene;
using carrier_track::Seconds;

using std::numbers::pi;
constexpr double omega = 30.0;

TEST(Lyapunov, CarriesADifferenceAsDualNumbersDo) {
  using Jet = ceres::Jet<double, 1>;
  carrier_track::RandomScenes scenes(31);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    Scene scene = scenes.next();
    if (scene.start_velocity == 0) scene.start_velocity = 0.05;  // at rest there is no derivative
    const auto end = carried(scene, {1.0, 2.0});
    if (!end) continue;
    auto dual = carrier_track::lifted<Jet>(scene);
    dual.start_position.v[0] = 1.0;
    dual.start_velocity.v[0] = 2.0;
    carrier_track::Observer nobody;
    const auto expected = carrier_track::simulate(dual, nobody);
    const double size = std::abs(expected.position.v[0]) + std::abs(expected.velocity.v[0]);
    EXPECT_NEAR(end->position, expected.position.v[0], 1e-8 * size) << i;
    EXPECT_NEAR(end->velocity, expected.velocity.v[0], 1e-8 * size) << i;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

/// Slides to a stop by friction of 0.5 m/s^2.
Scene sliding() {
  Scene scene;
  scene.wall_lower = -1;
  scene.wall_upper = 1;
  scene.start_position = 0;
  scene.start_velocity = -0.4;
  scene.friction = 0.25;
  scene.normal_force = 2.0;
  scene.window = Seconds{100};
  return scene;
}

TEST(Lyapunov, IsZeroForABodyThatFrictionStopsInTheGap) {
  // It stops after v |v| / (2 friction): the place remembers the start, the velocity does not.
  const auto end = carried(sliding(), {3e-3, 1e-3});
  EXPECT_NEAR(end->position, 3e-3 + 0.4 / 0.5 * 1e-3, 1e-15);
  EXPECT_EQ(end->velocity, 0);
  EXPECT_EQ(sensitivity_of(sliding()).exponent(), 0.0);
}

TEST(Lyapunov, IsMinusInfinityForABodyThatRestsOnAWall) {
  Scene scene = sliding();
  scene.pull = 2.0;
  EXPECT_FALSE(carried(scene, {1, 1}).has_value());
  const Sensitivity sensitivity = sensitivity_of(scene);
  EXPECT_FALSE(sensitivity.exponent().has_value());
  EXPECT_FALSE(sensitivity.chaotic());
  EXPECT_NEAR(sensitivity.rests_on_wall, 1.0 / 100, 1e-12);
}

/// A ball on a table shaken with peak acceleration `strength` gravity, on the orbit that strikes
/// once a period.
Scene on_table(double strength, double e) {
  constexpr double gravity = 9.81;
  const double cosine = pi * (1 - e) / ((1 + e) * strength);
  Scene scene;
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.omega = omega;
  scene.centrifugal_mass_radius = strength * gravity / (omega * omega);
  scene.phase = std::acos(cosine) - pi / 2;
  scene.restitution_lower = e;
  scene.start_position = 0;
  scene.pull = gravity;
  scene.start_velocity = e / (1 + e) * gravity * 2 * pi / omega;
  scene.window = Revolutions{100.5};
  return scene;
}

/// ln of the larger multiplier of that orbit. Their product is e^2. Their sum is linear in G sin of
/// the phase, and known where the orbit is born (multiplier 1, sine 0) and where it doubles (-1).
double table_exponent(double strength, double e) {
  const double sine = std::sqrt(strength * strength - std::pow(pi * (1 - e) / (1 + e), 2));
  const double trace = 1 + e * e - (1 + e) * (1 + e) * sine;
  const double square = trace * trace / 4 - e * e;
  return square < 0 ? std::log(e) : std::log(std::abs(trace) / 2 + std::sqrt(square));
}

double doubling_strength(double e) {
  return std::hypot(pi * (1 - e) / (1 + e), 2 * (1 + e * e) / ((1 + e) * (1 + e)));
}

TEST(Lyapunov, IsThatOfTheMultipliersOfABallOnAShakenTable) {
  for (const double e : {0.2, 0.5, 0.8}) {
    const double born = pi * (1 - e) / (1 + e);
    const double doubled = doubling_strength(e);
    EXPECT_NEAR(table_exponent(doubled, e), 0.0, 1e-7);
    for (const double share : {0.02, 0.3, 0.9, 0.99, 1.0}) {
      const double strength = born + share * (doubled - born);
      const Sensitivity sensitivity = sensitivity_of(on_table(strength, e));
      const double turn = 2 * pi / omega;
      EXPECT_NEAR(sensitivity.impacts * turn, 1, 0.02);
      // What a window of 90 turns leaves of a start in any direction.
      EXPECT_NEAR(*sensitivity.exponent() * turn, table_exponent(strength, e), 0.04)
          << e << " " << share;
    }
  }
}

/// The scene "mild" is on its way to the symmetric orbit with restitution 0.5.
TEST(Lyapunov, IsLnOfRestitutionAnImpactBetweenShakenWalls) {
  Scene scene = benchmark_scenes(1).front().scene;
  scene.window = Seconds{20};
  const Sensitivity sensitivity = sensitivity_of(scene);
  EXPECT_NEAR(sensitivity.impacts, 2 * 10, 0.1);
  EXPECT_NEAR(sensitivity.growth / sensitivity.impacts, std::log(0.5), 5e-3);
  EXPECT_FALSE(sensitivity.impacts_foretold().has_value());
}

TEST(Lyapunov, ForetellsWhenRunsOneRoundingApartPart) {
  const BenchmarkScene benchmark = benchmark_scenes(8).back();
  ASSERT_TRUE(benchmark.chaotic);
  Scene scene = benchmark.scene;
  const double all_digits = 53 * std::log10(2.0);
  int parted = 0;
  for (int k = 0; k < 32; ++k) {
    scene.start_velocity = 0.03 * (1 + 0.01 * k);
    if (!carried(scene, {1, 1})) continue;  // it rests on a wall, and the runs are one again
    const auto digits = digits_lost_by_impact(scene, 1000);
    const auto lost = std::find_if(digits.begin(), digits.end(),
                                   [&](double lost_here) { return lost_here > all_digits; });
    const auto seen = impacts_until_parted(scene);
    ASSERT_TRUE(seen.has_value()) << k;
    EXPECT_NEAR(*seen, static_cast<double>(lost - digits.begin()), 20) << k;
    ++parted;
  }
  EXPECT_GE(parted, 8);
}

TEST(Lyapunov, FindsNoPairOfRunsOfAPaperCaseThatParts) {
  const LyapunovStudy study = study_lyapunov({{3, 10}, 20, 4});
  ASSERT_EQ(study.cells.size(), 12U);
  for (const auto& row : study.cells) {
    ASSERT_EQ(row.size(), 2U);
    for (const Sensitivity& cell : row) {
      EXPECT_FALSE(cell.exponent().has_value());
      EXPECT_LT(cell.digits_lost, 8);
    }
  }
  ASSERT_EQ(study.courses.size(), 3U);
  EXPECT_TRUE(study.courses[0].parted.empty());
  EXPECT_TRUE(study.courses[1].parted.empty());
  EXPECT_FALSE(study.courses[2].parted.empty());
}

}  // namespace
}  // namespace ricochet::studies::dynamics
