#include "problems/carrier_track/suite/design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

Machine c1_machine() {
  return machine_of(find_case("C1"), exploratory_scene());
}

constexpr DesignScale scale{10.0, 1.0, 4.0, 2e-3};

DesignCost<double> cost_of(double speed, double pull, double clearance, double friction,
                           double restitution) {
  const std::array<double, 5> x = {speed, pull, clearance, friction, restitution};
  return design_cost(scale, std::span<const double>(x));
}

TEST(Design, CostsWhatItsTermsSay) {
  const auto cost = cost_of(5.0, 3.0, 1e-3, 0.4, std::exp(-2.0));
  EXPECT_DOUBLE_EQ(cost.production, -0.5);
  EXPECT_DOUBLE_EQ(cost.precision, 1.0);  // half the clearance, twice the cost
  EXPECT_DOUBLE_EQ(cost.damping, 0.5);
  EXPECT_DOUBLE_EQ(cost.heat, 0.5 * 0.4 / 8);
  EXPECT_DOUBLE_EQ(cost.tension, 0.25);
  EXPECT_DOUBLE_EQ(cost.sum(), -0.5 + 1.0 + 0.5 + 0.025 + 0.25);
}

TEST(Design, CostsNoTensionAtTheNominalPullAndNoDampingWithoutAny) {
  const auto cost = cost_of(5.0, 1.0, 2e-3, 0.1, 1.0);
  EXPECT_EQ(cost.tension, 0);
  EXPECT_EQ(cost.damping, 0);
}

TEST(Design, OfTheMachineAsItIsHasItsCount) {
  const Machine m = c1_machine();
  const Problem problem = design_count_problem(m);
  Vector x = problem.start;
  x[design_speed] = 9.0;
  const double count = problem.evaluate(x).constraints[0] + m.quiet_limit;
  EXPECT_EQ(count, count_at(m.scene, 9.0));
}

TEST(Design, BuildsTheSceneOfItsVariables) {
  const std::array<double, 5> x = {5.0, 2.0, 2 * 1.04e-3, 0.3, 0.7};
  const Scene scene = designed(c1_machine().scene, std::span<const double>(x));
  EXPECT_EQ(scene.omega, 5.0);
  EXPECT_EQ(scene.pull, 2.0);
  EXPECT_DOUBLE_EQ(scene.wall_upper, 2 * 1.04e-3);
  EXPECT_DOUBLE_EQ(scene.start_position, 0.54 * 2 * 1.04e-3);
  EXPECT_EQ(scene.friction, 0.3);
  EXPECT_EQ(scene.restitution_lower, 0.7);
  EXPECT_EQ(scene.restitution_upper, 0.7);
}

TEST(Design, HasDerivativesToEveryVariable) {
  const Problem problem = design_count_problem(c1_machine()).formulated({0.25});
  const Vector x = problem.lower + 0.37 * (problem.upper - problem.lower);
  expect_derivatives_of_values(problem, x, 1e-8, 1e-4);
}

TEST(Design, IsJudgedByTheTrueCount) {
  const Problem smooth = design_count_problem(c1_machine()).formulated({0.25});
  const Problem exact = design_count_problem(c1_machine());
  const Vector x = smooth.lower + 0.9 * (smooth.upper - smooth.lower);
  const TrueValues true_values = smooth.true_values(x);
  EXPECT_GT(true_values.violation, 0);
  EXPECT_EQ(true_values.violation, exact.evaluate(x).constraints[0]);
  EXPECT_EQ(true_values.objective, exact.evaluate(x).objective);
}

TEST(Design, IsNotAskedOfAMachineWithOneWall) {
  Machine m = c1_machine();
  m.scene.wall_upper = std::numeric_limits<double>::infinity();
  EXPECT_EQ(families_of({c1_machine(), m})[4].problems.size(), 1U);
}

}  // namespace
}  // namespace ricochet::carrier_track
