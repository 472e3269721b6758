#include "problems/carrier_track/suite/machine.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

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
  const Scene scene = scene_of(find_case("C1"), exploratory_scene());
  const Machine machine = machine_of(scene, "a scene");
  const QuietRule rule = quiet_rule_of(scene, 1e-3);
  EXPECT_EQ(machine.id, "scene");
  EXPECT_EQ(machine.quiet_limit, rule.limit);
  EXPECT_EQ(machine.threshold, rule.threshold);
}

TEST(Machine, OfASpeedProfileIsRefused) {
  Scene scene = exploratory_scene();
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
  Scene scene;
  EXPECT_TRUE(carries_derivatives(scene));
  for (const Fidelity other : {Fidelity::compliant, Fidelity::planar, Fidelity::automatic}) {
    scene.fidelity = other;
    EXPECT_FALSE(carries_derivatives(scene));
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
