#include "problems/carrier_track/suite/machine.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

TEST(Cases, AreTwelveOfDistinctIdAndConstants) {
  std::set<std::string> ids;
  std::set<std::vector<double>> constants;
  for (const Case& c : all_cases()) {
    ids.insert(c.id);
    constants.insert({c.restitution, c.friction, c.disturbance});
  }
  EXPECT_EQ(all_cases().size(), 12U);
  EXPECT_EQ(ids.size(), 12U);
  EXPECT_EQ(constants.size(), 12U) << "every combination of 2 x 2 x 3 values";
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

TEST(Cases, ClaimThatBouncierIsLouderSooner) {
  // Conclusion (A): at equal friction and disturbance the threshold falls as restitution rises.
  for (const Case& dull : all_cases()) {
    for (const Case& bouncy : all_cases()) {
      if (!dull.claim.threshold || !bouncy.claim.threshold) continue;
      if (dull.friction != bouncy.friction || dull.disturbance != bouncy.disturbance) continue;
      if (dull.restitution < bouncy.restitution) {
        EXPECT_GT(*dull.claim.threshold, *bouncy.claim.threshold) << dull.id << " " << bouncy.id;
      }
    }
  }
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
  EXPECT_EQ(machine.id, "C1");
  EXPECT_EQ(machine.scene.restitution_lower, 0.1);
  EXPECT_EQ(machine.threshold, 9.0);
  const Score scored = score(machine.scene, a_case.claim, ScanOptions{1e-2, 1, 18.0});
  EXPECT_EQ(machine.quiet_limit, 1.5 * scored.quiet_count);
  EXPECT_EQ(machine.default_hash, "");
}

TEST(Machine, OfASceneHasTheLimitAndTheThresholdOfItsLongRun) {
  Scene scene = scene_of(find_case("C1"), exploratory_scene());
  const Machine machine = machine_of(scene, "a scene");
  const QuietRule rule = quiet_rule_of(scene, 1e-3);
  EXPECT_EQ(machine.id, "scene");
  EXPECT_EQ(machine.quiet_limit, rule.limit);
  EXPECT_EQ(machine.threshold, rule.threshold);
  scene.profile = {{0.0, 3.0}};
  EXPECT_THROW(machine_of(scene, "a scene"), InputError);
}

TEST(Machine, TheCasesAreOfTheDefaultMachine) {
  const std::vector<Machine> machines = all_machines();
  ASSERT_EQ(machines.size(), 12U);
  for (const Machine& machine : machines) EXPECT_EQ(machine.default_hash, default_machine_hash());
  EXPECT_EQ(machines[10].threshold, std::nullopt);  // the paper claims none
}

TEST(Machine, IsLoudAQuarterAboveItsThresholdOrAtSix) {
  EXPECT_EQ(loud_speed({"a", {}, 6, 8.0, ""}), 10.0);
  EXPECT_EQ(loud_speed({"a", {}, 6, std::nullopt, ""}), 6.0);
}

TEST(Machine, ASurrogateIsComparedHalfACollisionAboveTheHighestQuietCount) {
  EXPECT_EQ(half_level(7.5), 7.5);  // 7 is quiet, 8 is not
  EXPECT_EQ(half_level(18.0), 18.5);
  EXPECT_EQ(half_level(0.0), 0.5);
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
    for (const auto constant :
         {&Scene::mass, &Scene::restitution_lower, &Scene::restitution_upper, &Scene::friction,
          &Scene::normal_force, &Scene::pull, &Scene::centrifugal_mass_radius, &Scene::disturbance,
          &Scene::disturbance_frequency, &Scene::start_velocity}) {
      EXPECT_NE(scene.*constant, nominal.*constant);
      ratios.insert(scene.*constant / (nominal.*constant));
    }
    EXPECT_NE(scene.wall_upper - scene.wall_lower, nominal.wall_upper - nominal.wall_lower);
    ratios.insert((scene.wall_upper - scene.wall_lower) /
                  (nominal.wall_upper - nominal.wall_lower));
    EXPECT_EQ(scene.counting_limit, nominal.counting_limit);
    EXPECT_EQ(std::get<Revolutions>(scene.window).count, 1.314);
    EXPECT_NO_THROW(check(scene, "drawn"));
  }
  EXPECT_GE(*ratios.begin(), 0.95 - 1e-12);
  EXPECT_LT(*ratios.begin(), 0.951);
  EXPECT_GT(*ratios.rbegin(), 1.049);
  EXPECT_LE(*ratios.rbegin(), 1.05 + 1e-12);
}

TEST(DrawnMachine, KeepsAPerfectRestitutionPossible) {
  Machine machine = c9();
  machine.scene = with(machine.scene, set::restitution(1));
  for (int number = 1; number < 20; ++number)
    EXPECT_LE(drawn_machine(machine, number).scene.restitution_lower, 1.0);
}

TEST(DrawnMachine, KeepsLimitAndThresholdAndForgetsTheHash) {
  const Machine drawn = drawn_machine(c9(), 3);
  EXPECT_EQ(drawn.id, "C9~3");
  EXPECT_EQ(drawn.quiet_limit, c9().quiet_limit);
  EXPECT_EQ(drawn.threshold, 7.3);
  EXPECT_EQ(drawn.default_hash, "");
  EXPECT_EQ(count_problem(drawn).name, "count-C9~3");
  const Machine itself = drawn_machine(c9(), 0);
  EXPECT_EQ(itself.id, "C9");
  EXPECT_EQ(itself.default_hash, "some hash");
  EXPECT_EQ(write_scene(itself.scene), write_scene(c9().scene));
  EXPECT_THROW(drawn_machine(c9(), -1), std::invalid_argument);
}

constexpr double scan_step = 1e-3;

Scene machine_with(double restitution, double friction, double disturbance = 0) {
  return scene_of({"mine", restitution, friction, disturbance, {}}, default_machine());
}

double fastest_up_to(const Scene& scene, double limit) {
  const SpeedScan scan = scan_speeds(scene, scan_step, fastest_speed);
  double fastest = 0;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.counts[k] <= limit) fastest = scan.omega(k);
  }
  return fastest;
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
  const QuietRule quiet = quiet_rule_of(with(hard, set::counting_limit(10)), scan_step);
  EXPECT_EQ(quiet.threshold, std::nullopt) << "every speed is quiet";
  EXPECT_EQ(quiet.limit, 0.5);
}

TEST(QuietRule, OfPeaksIsThatOfTheWindow) {
  const Scene peaks = with(machine_with(0.9, 0.1), set::rule(CountRule::peaks));
  const QuietRule rule = quiet_rule_of(peaks, 1e-2);
  const Score found = score(peaks, Claim{}, ScanOptions{1e-2, 1});
  EXPECT_EQ(rule.limit, quiet_limit(found.quiet_count));
  EXPECT_EQ(rule.threshold, found.threshold);
}

}  // namespace
}  // namespace ricochet::carrier_track
