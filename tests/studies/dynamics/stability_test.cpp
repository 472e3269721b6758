#include "src/studies/dynamics/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

Integrator penalty(const std::string& name) {
  for (const Integrator& integrator : through_walls()) {
    if (integrator.name == name) return integrator;
  }
  throw std::invalid_argument("no penalty method " + name);
}

TEST(Stability, OfARunIsJudgedByTheWorstThatHappened) {
  Scene scene;
  const auto seen = [](int impacts) {
    Outcome outcome;
    outcome.finished = true;
    for (int i = 0; i < impacts; ++i) outcome.impacts.push_back({0.1 * i, Wall::lower, 1.0});
    return outcome;
  };
  const Outcome true_values = seen(3);
  EXPECT_EQ(behaviour_of(scene, seen(3), true_values), Behaviour::right_count);
  EXPECT_EQ(behaviour_of(scene, seen(4), true_values), Behaviour::too_many);
  EXPECT_EQ(behaviour_of(scene, seen(2), true_values), Behaviour::too_few);
  Outcome outcome = seen(2);
  outcome.gained = -0.1;
  EXPECT_EQ(behaviour_of(scene, outcome, true_values), Behaviour::too_few);
  outcome.gained = 0.1;
  EXPECT_EQ(behaviour_of(scene, outcome, true_values), Behaviour::gains_energy);
  outcome.finished = false;
  EXPECT_EQ(behaviour_of(scene, outcome, true_values), Behaviour::gives_up);
  outcome.deepest = std::numeric_limits<double>::infinity();
  EXPECT_EQ(behaviour_of(scene, outcome, true_values), Behaviour::leaves_the_walls);
}

TEST(Stability, OfTheFrequencyAtThePeakIsThatOfALinearSpring) {
  Scene scene = stiff_gap(4e4);
  scene.contact_law = ContactLaw::hertz;
  scene.contact_exponent = 1;
  EXPECT_NEAR(peak_frequency(scene, 0.3), 200, 1e-9);  // sqrt(K/m), whatever the speed
  // Hertz: contact time 2.94328 d/v, and w = sqrt(1.5 K d^0.5 / m) with K d^2.5 = 1.25 m v^2.
  scene.contact_exponent = 1.5;
  const double depth = std::pow(1.25 * 0.09 / 4e4, 0.4);
  EXPECT_NEAR(peak_frequency(scene, 0.3), std::sqrt(1.5 * 1.25) * 0.3 / depth, 1e-6);
}

TEST(Stability, OfFixedStepsIsGoneAtTwiceTheBoundAndThereAtATenthWhateverTheStiffness) {
  const StabilityPlan plan{{1e9, 1e12, 1e15}, {}, {}};
  for (const char* name : {"semi-implicit-euler", "runge-kutta-4"}) {
    const double bound = *spring_bound(name);
    for (const double stiffness : plan.stiffnesses) {
      const double w = peak_frequency(stiff_gap(stiffness), 0.1);
      StabilityPlan steps = plan;
      steps.stiffnesses = {stiffness};
      for (const double share : {2.0, 0.1}) steps.steps.push_back(share * bound / w);
      const StabilityMap map = map_of(penalty(name), steps);
      EXPECT_EQ(map.cells[0][1].behaviour, Behaviour::right_count) << name << " " << stiffness;
      EXPECT_GE(map.cells[0][0].behaviour, Behaviour::gains_energy) << name << " " << stiffness;
    }
  }
}

TEST(Stability, OfAdaptiveMethodsIsRightAtTightTolerances) {
  const StabilityPlan plan{{1e8, 1e16}, {}, {1e-6, 1e-9}};
  for (const Integrator& integrator : through_walls()) {
    if (integrator.setting != "relative tolerance") continue;
    for (const auto& row : map_of(integrator, plan).cells) {
      for (const StabilityCell& cell : row) {
        EXPECT_EQ(cell.behaviour, Behaviour::right_count) << integrator.name;
      }
    }
  }
}

TEST(Stability, GivesTheBorderInScaledSteps) {
  const auto cell = [](Behaviour behaviour) { return StabilityCell{behaviour, 1}; };
  const StabilityMap map{"a",
                         "step [s]",
                         {0.1, 0.01},
                         {{cell(Behaviour::gains_energy), cell(Behaviour::right_count)},
                          {cell(Behaviour::leaves_the_walls), cell(Behaviour::too_few)}}};
  const Border border = border_of(map, {10, 100});
  EXPECT_DOUBLE_EQ(border.lowest_bad, 1);
  EXPECT_DOUBLE_EQ(border.highest_good, 1);
  EXPECT_FALSE(cheapest_right(map.cells[1]).has_value());
  EXPECT_TRUE(cheapest_right(map.cells[0]).has_value());
}

}  // namespace
}  // namespace ricochet::studies::dynamics
