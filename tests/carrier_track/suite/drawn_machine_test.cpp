#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <variant>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/scene.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

Machine c9() {
  Machine machine = machine_of(find_case("C9"), exploratory_scene());
  machine.default_hash = "some hash";
  return machine;
}

TEST(DrawnMachine, IsTheSameEveryTimeAndAnotherForEveryNumber) {
  EXPECT_EQ(write_scene(drawn_machine(c9(), 3).scene), write_scene(drawn_machine(c9(), 3).scene));
  std::set<std::string> scenes;
  for (int number = 0; number < 20; ++number) {
    scenes.insert(write_scene(drawn_machine(c9(), number).scene));
  }
  EXPECT_EQ(scenes.size(), 20U);
}

/// Every constant is scaled by its own factor within 5 %, and by all of the range in many draws.
TEST(DrawnMachine, HasEveryConstantWithinFivePerCent) {
  const Scene nominal = c9().scene;
  double least = 2, most = 0;
  const auto expect_near = [&](double x, double of) {
    EXPECT_NE(x, of);
    EXPECT_GE(x / of, 0.95 - 1e-12);
    EXPECT_LE(x / of, 1.05 + 1e-12);
    least = std::min(least, x / of);
    most = std::max(most, x / of);
  };
  for (int number = 1; number < 100; ++number) {
    const Scene scene = drawn_machine(c9(), number).scene;
    expect_near(scene.mass, nominal.mass);
    expect_near(scene.wall_upper - scene.wall_lower, nominal.wall_upper - nominal.wall_lower);
    expect_near(scene.restitution_lower, nominal.restitution_lower);
    expect_near(scene.restitution_upper, nominal.restitution_upper);
    expect_near(scene.friction, nominal.friction);
    expect_near(scene.normal_force, nominal.normal_force);
    expect_near(scene.pull, nominal.pull);
    expect_near(scene.centrifugal_mass_radius, nominal.centrifugal_mass_radius);
    expect_near(scene.disturbance, nominal.disturbance);
    expect_near(scene.disturbance_frequency, nominal.disturbance_frequency);
    expect_near(scene.start_velocity, nominal.start_velocity);
    EXPECT_EQ(scene.counting_limit, nominal.counting_limit);
    EXPECT_EQ(std::get<Revolutions>(scene.window).count, 1.314);
    EXPECT_NO_THROW(check(scene, "drawn"));
  }
  EXPECT_LT(least, 0.951);
  EXPECT_GT(most, 1.049);
}

TEST(DrawnMachine, KeepsAPerfectRestitutionPossible) {
  Machine machine = c9();
  machine.scene.restitution_lower = machine.scene.restitution_upper = 1;
  for (int number = 1; number < 20; ++number) {
    EXPECT_LE(drawn_machine(machine, number).scene.restitution_lower, 1.0);
  }
}

TEST(DrawnMachine, KeepsLimitAndThresholdAndForgetsTheHash) {
  const Machine drawn = drawn_machine(c9(), 3);
  EXPECT_EQ(drawn.id, "C9~3");
  EXPECT_EQ(drawn.quiet_limit, c9().quiet_limit);
  EXPECT_EQ(drawn.threshold, 7.3);
  EXPECT_EQ(drawn.default_hash, "");
  EXPECT_EQ(count_problem(drawn).name, "count-C9~3");
}

TEST(DrawnMachine, OfNumberZeroIsTheMachineItself) {
  const Machine machine = drawn_machine(c9(), 0);
  EXPECT_EQ(machine.id, "C9");
  EXPECT_EQ(machine.default_hash, "some hash");
  EXPECT_EQ(write_scene(machine.scene), write_scene(c9().scene));
}

TEST(DrawnMachine, HasNoNumberBelowZero) {
  EXPECT_THROW(drawn_machine(c9(), -1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
