#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/counting/held_scene.h"

namespace ricochet::carrier_track {
namespace {

const Limit none{Measure::collisions, 0};

TEST(Sensitivity, KnowsTheConstantsThatAreNotZero) {
  EXPECT_THAT(
      constants_of(held()),
      testing::UnorderedElementsAre("mass", "friction", "normal_force", "centrifugal_mass_radius",
                                    "disturbance_frequency", "clearance"));
  Scene scene = held();
  scene.restitution_lower = 0.5;
  scene.across.emplace();
  scene.across->pull = 2;
  EXPECT_THAT(constants_of(scene),
              testing::IsSupersetOf(
                  {"restitution", "across.pull", "across.restitution", "across.clearance"}));
}

TEST(Sensitivity, ScalesOneConstant) {
  Scene scene = held();
  scene.wall_lower = 3;
  scene.wall_upper = 5;
  scene.start_position = 3.5;
  scene.restitution_lower = 0.8;
  const Scene wider = scaled(scene, "clearance", 1.5);
  EXPECT_DOUBLE_EQ(wider.wall_lower, 3);
  EXPECT_DOUBLE_EQ(wider.wall_upper, 6);
  EXPECT_DOUBLE_EQ(wider.start_position, 3.75);
  EXPECT_EQ(wider.mass, scene.mass);
  EXPECT_DOUBLE_EQ(scaled(scene, "mass", 2).mass, 2);
  EXPECT_DOUBLE_EQ(scaled(scene, "restitution", 1.1).restitution_lower, 0.88);
  EXPECT_DOUBLE_EQ(scaled(scene, "restitution", 2).restitution_lower, 1);
}

TEST(Sensitivity, FindsTheDivideToAFiftythousandth) {
  const auto divide = divide_near(held(), none, 9);
  ASSERT_TRUE(divide);
  EXPECT_NEAR(*divide, std::sqrt(100.01), 10 * 2e-5);  // where it just reaches the wall in 10 s
  EXPECT_FALSE(divide_near(held(), none, 2));
  EXPECT_FALSE(divide_near(held(), none, 30));
}

TEST(Sensitivity, IsThatOfTheClosedForm) {
  std::map<std::string, double> by_key;
  for (const Sensitivity& s : sensitivities(held(), none, 10)) by_key[s.key] = s.percent;
  EXPECT_NEAR(by_key.at("friction"), 0.5, 0.005);
  EXPECT_NEAR(by_key.at("normal_force"), 0.5, 0.005);
  EXPECT_NEAR(by_key.at("centrifugal_mass_radius"), -0.5, 0.005);
  EXPECT_NEAR(by_key.at("mass"), 0, 0.005);
  EXPECT_NEAR(by_key.at("clearance"), 0, 0.005);
}

TEST(Sensitivity, AddsUpToNothingOverAllThatHasAMassInItsUnit) {
  // Mass and forces of twice the size move the same way.
  const Scene scene = scene_of(find_case("C1"), default_machine());
  const auto all = sensitivities(scene, {Measure::collisions, 6}, 8.27);
  double sum = 0;
  bool large = false;
  for (const Sensitivity& s : all) {
    if (s.key == "mass" || s.key == "normal_force" || s.key == "pull" || s.key == "disturbance" ||
        s.key == "centrifugal_mass_radius" || s.key == "slider_mass_radius") {
      sum += s.percent;
      large |= std::abs(s.percent) > 0.1;
    }
  }
  EXPECT_TRUE(large);
  EXPECT_NEAR(sum, 0, 0.02);
  EXPECT_GE(std::abs(all.front().percent), std::abs(all.back().percent));
}

TEST(Sensitivity, HasTheCountingLimitWhereImpactsCount) {
  // The long run's border of C1 is where an impact reaches the limit.
  Scene scene = scene_of(find_case("C1"), default_machine());
  const Limit limit{Measure::collisions_per_turn, 2};
  const auto border = [&](double factor) {
    Scene changed = scene;
    changed.counting_limit *= factor;
    return divide_near(changed, limit, 8.08).value();
  };
  const double exponent = std::log(border(1.02) / border(0.98)) / std::log(1.02 / 0.98);
  EXPECT_GT(exponent, 0.8);
  std::map<std::string, double> by_key;
  for (const Sensitivity& s : sensitivities(scene, limit, 8.08)) by_key[s.key] = s.percent;
  EXPECT_NEAR(by_key.at("counting_limit"), exponent, 0.01);
  EXPECT_THAT(constants_of(scene), testing::Not(testing::Contains("counting_limit")))
      << "drawn machines and tolerances are those of manufacture";
}

TEST(Sensitivity, RefusesWhatIsInvalid) {
  Scene broken = held();
  broken.mass = -1;
  EXPECT_THROW(sensitivities(broken, none, 1), InputError);
  EXPECT_THROW(sensitivities(held(), none, 0), InputError);
  EXPECT_THROW(tolerance_range(broken, none, 1, 0.1, 9, 1), InputError);
  for (const double omega : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(tolerance_range(held(), none, omega, 0.1, 9, 1), InputError);
  }
  for (const double tolerance : {-0.1, 0.6, std::nan("")}) {
    EXPECT_THROW(tolerance_range(held(), none, 1, tolerance, 9, 1), InputError);
  }
  EXPECT_THROW(tolerance_range(held(), none, 1, 0.1, 0, 1), InputError);
}

TEST(Sensitivity, DrawsMachinesWithinTheTolerance) {
  const auto range = tolerance_range(held(), none, 10, 0.1, 300, 1);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->machines, 300);
  EXPECT_EQ(range->without, 0);
  const double lowest = 10 * std::sqrt(0.9 * 0.9 / 1.1);
  const double highest = 10 * std::sqrt(1.1 * 1.1 / 0.9);
  EXPECT_GE(range->lowest, lowest * (1 - 1e-4));
  EXPECT_LE(range->highest, highest * (1 + 1e-4));
  EXPECT_LT(range->lowest, 10 - 0.6 * (10 - lowest));  // and they reach far into the corners
  EXPECT_GT(range->highest, 10 + 0.6 * (highest - 10));
  const auto again = tolerance_range(held(), none, 10, 0.1, 300, 1);
  EXPECT_EQ(again->lowest, range->lowest);
  EXPECT_EQ(again->highest, range->highest);
  EXPECT_FALSE(tolerance_range(held(), none, 2, 0.1, 3, 1));
}

}  // namespace
}  // namespace ricochet::carrier_track
