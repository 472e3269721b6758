#include "problems/carrier_track/suite/machine.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(Cases, AreTwelveOfDistinctIdAndConstants) {
  std::set<std::string> ids;
  std::set<std::vector<double>> constants;
  for (const Case& c : all_cases()) {
    EXPECT_TRUE(ids.insert(c.id).second);
    EXPECT_TRUE(constants.insert({c.restitution, c.friction, c.disturbance}).second);
  }
  EXPECT_EQ(all_cases().size(), 12U) << "every combination of 2 x 2 x 3 values";
}

TEST(Cases, ClaimThresholdsBetweenTheSpeedsOfTheirFigures) {
  int claims = 0;
  for (const Case& c : all_cases()) {
    ASSERT_EQ(c.claim.threshold.has_value(), c.claim.figure.has_value()) << c.id;
    ASSERT_EQ(c.claim.threshold.has_value(), c.claim.quiet_count.has_value()) << c.id;
    if (!c.claim.threshold) continue;
    EXPECT_LT(c.claim.figure->quiet, *c.claim.threshold) << c.id;
    EXPECT_GT(c.claim.figure->loud, *c.claim.threshold) << c.id;
    EXPECT_EQ(c.claim.figure->number, 5 + claims) << "figures 5 to 14 follow the cases";
    ++claims;
  }
  EXPECT_EQ(claims, 10);
}

TEST(Cases, AreFoundByTheirIdAndPutTheirConstantsIntoAScene) {
  EXPECT_EQ(find_case("C11").restitution, 0.9);
  EXPECT_EQ(find_case("C11").disturbance, 1.0);
  EXPECT_EQ(find_case("C3").claim.threshold, 13.0);
  expect_refusals(find_case, {{"C13", "C13"}, {"C13", "did you mean C1 or C3"}});
  EXPECT_EQ(write_scene(scene_of(find_case("C8"), exploratory_scene())),
            write_scene(with(exploratory_scene(), set::restitution(0.9), set::friction(0.4),
                             set::disturbance(0.1))));
}

TEST(Machine, OfACaseHasItsSceneAndTheLimitOfItsClaim) {
  const Case a_case = find_case("C1");
  const Machine machine = machine_of(a_case, exploratory_scene());
  const Score scored = score(machine.scene, a_case.claim, ScanOptions{1e-2, 1, 18.0});
  EXPECT_THAT(machine, FieldsAre("C1", testing::_, 1.5 * scored.quiet_count, 9.0, ""));
  EXPECT_EQ(machine.scene.restitution_lower, 0.1);
}

TEST(Machine, OfASceneHasTheLimitAndTheThresholdOfItsLongRun) {
  Scene scene = scene_of(find_case("C1"), exploratory_scene());
  const QuietRule rule = quiet_rule_of(scene, 1e-3);
  EXPECT_THAT(machine_of(scene, "a scene"),
              FieldsAre("scene", testing::_, rule.limit, rule.threshold, ""));
  scene.profile = {{0.0, 3.0}};
  EXPECT_THROW(machine_of(scene, "a scene"), InputError);
}

TEST(Machine, IsLoudAQuarterAboveItsThresholdOrAtSix) {
  EXPECT_EQ(loud_speed({"a", {}, 6, 8.0, ""}), 10.0);
  EXPECT_EQ(loud_speed({"a", {}, 6, std::nullopt, ""}), 6.0);
}

TEST(Machine, CarriesDerivativesBetweenHardWallsInOneDirection) {
  EXPECT_TRUE(carries_derivatives(Scene{}));
  for (const Fidelity other : {Fidelity::compliant, Fidelity::planar, Fidelity::automatic})
    EXPECT_FALSE(carries_derivatives(with(Scene{}, set::fidelity(other))));
}

Machine c9() {
  Machine machine = exploratory_machine("C9");
  machine.default_hash = "some hash";
  return machine;
}

TEST(DrawnMachine, IsTheSameEveryTimeAndAnotherForEveryNumber) {
  std::set<std::string> scenes;
  for (int k = 0; k < 40; ++k) scenes.insert(write_scene(drawn_machine(c9(), k % 20).scene));
  EXPECT_EQ(scenes.size(), 20U);
}

/// Every constant is scaled by its own factor within 5 %, and by all of the range in many draws.
TEST(DrawnMachine, HasEveryConstantWithinFivePerCent) {
  const Scene nominal = c9().scene;
  std::set<double> ratios;
  for (int number = 1; number < 100; ++number) {
    const Scene scene = drawn_machine(c9(), number).scene;
    const auto compare = [&](double drawn, double original) {
      EXPECT_NE(drawn, original);
      ratios.insert(drawn / original);
    };
    for (const auto constant :
         {&Scene::mass, &Scene::restitution_lower, &Scene::restitution_upper, &Scene::friction,
          &Scene::normal_force, &Scene::pull, &Scene::centrifugal_mass_radius, &Scene::disturbance,
          &Scene::disturbance_frequency, &Scene::start_velocity}) {
      compare(scene.*constant, nominal.*constant);
    }
    compare(scene.wall_upper - scene.wall_lower, nominal.wall_upper - nominal.wall_lower);
    EXPECT_EQ(scene.counting_limit, nominal.counting_limit);
    EXPECT_EQ(std::get<Revolutions>(scene.window).count, 1.314);
    EXPECT_NO_THROW(check(scene, "drawn"));
  }
  EXPECT_NEAR(*ratios.begin(), 0.9505, 0.0005 + 1e-12);
  EXPECT_NEAR(*ratios.rbegin(), 1.0495, 0.0005 + 1e-12);
}

TEST(DrawnMachine, KeepsAPerfectRestitutionPossible) {
  Machine machine = c9();
  machine.scene.restitution_lower = 1;
  for (int number = 1; number < 20; ++number)
    EXPECT_LE(drawn_machine(machine, number).scene.restitution_lower, 1.0);
}

TEST(DrawnMachine, KeepsLimitAndThresholdAndForgetsTheHash) {
  const Machine drawn = drawn_machine(c9(), 3), itself = drawn_machine(c9(), 0);
  EXPECT_THAT(drawn, FieldsAre("C9~3", testing::_, c9().quiet_limit, 7.3, ""));
  EXPECT_EQ(count_problem(drawn).name, "count-C9~3");
  EXPECT_THAT(itself, FieldsAre("C9", testing::_, c9().quiet_limit, 7.3, "some hash"));
  EXPECT_EQ(write_scene(itself.scene), write_scene(c9().scene));
  EXPECT_THROW(drawn_machine(c9(), -1), std::invalid_argument);
}

constexpr double scan_step = 1e-3;

Scene machine_with(double restitution, double friction, double disturbance = 0) {
  return scene_of({"mine", restitution, friction, disturbance, {}}, default_machine());
}

double fastest_up_to(const Scene& scene, double limit) {
  const SpeedScan scan = scan_speeds(scene, scan_step, fastest_speed);
  std::size_t k = scan.counts.size();
  while (k > 0 && scan.counts[k - 1] > limit) --k;
  return k == 0 ? 0 : scan.omega(k - 1);
}

/// The window's fastest quiet speed is the border of the long run, whatever the restitution.
TEST(QuietRule, GivesTheWindowTheBorderOfTheLongRun) {
  for (const double restitution : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (const double friction : {0.1, 0.4}) {
      const Scene scene = machine_with(restitution, friction);
      const QuietRule rule = quiet_rule_of(scene, scan_step);
      ASSERT_TRUE(rule.threshold);
      EXPECT_EQ(rule.threshold, quiet_up_to(scene, quiet_per_turn));
      EXPECT_EQ(rule.limit - 0.5, std::floor(rule.limit)) << "half a collision above a count";
      EXPECT_NEAR(fastest_up_to(scene, rule.limit), *rule.threshold, scan_step)
          << restitution << ", " << friction;
    }
  }
}

/// A disturbance shows the window one of its phases, and the long run all: the window can only be
/// quieter.
TEST(QuietRule, IsOfTheLoudestPhaseOfADisturbance) {
  const Scene scene = machine_with(0.1, 0.1, 1);
  const QuietRule rule = quiet_rule_of(scene, scan_step);
  const double fastest = fastest_up_to(scene, rule.limit);
  EXPECT_GE(fastest, *rule.threshold - scan_step);
  EXPECT_NEAR(fastest, *rule.threshold, 0.02);
}

TEST(QuietRule, TakesTheThresholdOfHardWallsForEveryFidelityIfThereIsOne) {
  const Scene hard = machine_with(0.1, 0.4);
  EXPECT_EQ(quiet_rule_of(with(hard, set::planar()), scan_step).threshold,
            quiet_rule_of(hard, scan_step).threshold);
  EXPECT_THAT(quiet_rule_of(with(hard, set::counting_limit(10)), scan_step),
              FieldsAre(0.5, std::nullopt))
      << "every speed is quiet";
}

TEST(QuietRule, OfPeaksIsThatOfTheWindow) {
  const Scene peaks = with(machine_with(0.9, 0.1), set::rule(CountRule::peaks));
  const Score found = score(peaks, Claim{}, ScanOptions{1e-2, 1});
  EXPECT_THAT(quiet_rule_of(peaks, 1e-2),
              FieldsAre(quiet_limit(found.quiet_count), found.threshold));
}

}  // namespace
}  // namespace ricochet::carrier_track
