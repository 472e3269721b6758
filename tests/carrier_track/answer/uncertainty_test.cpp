#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/scene/scene_file.h"

namespace ricochet::carrier_track {
namespace {

/// Silent up to sqrt(friction normal_force / (mass path_radius)), where the first impact counts.
SceneFile silent_below(const std::string& friction, const std::string& mass) {
  return parse_scene_file("[scene]\nmass = " + mass + "\nfriction = " + friction +
                              "\nnormal_force = 10\npath_radius = 0.1\nwall_lower = 0\n"
                              "wall_upper = 1e-3\nrestitution = 0\nstart_position = 0\n"
                              "[window]\nrevolutions = 4\n[count]\ncounting_limit = 1e-9\n",
                          "own");
}

const Limit silence = {Measure::collisions, 0};

TEST(Uncertainty, MovesTheAnswerAsTheClosedFormDoes) {
  const SceneFile file =
      silent_below("{value = 0.2, plus_minus = 0.02}", "{value = \"1 kg\", plus_minus = \"50 g\"}");
  const double omega = std::sqrt(0.2 * 10 / 0.1);
  const UncertainDivide divide = uncertain_divide(file, silence, omega, 200, 1).value();
  ASSERT_EQ(divide.effects.size(), 2U);
  EXPECT_EQ(divide.effects[0].key, "scene.friction");
  EXPECT_NEAR(divide.effects[0].change, (std::sqrt(22.0) - std::sqrt(18.0)) / 2, 1e-3);
  EXPECT_EQ(divide.effects[1].key, "scene.mass");  // and with it the centrifugal force
  EXPECT_NEAR(divide.effects[1].change, omega * (1 / std::sqrt(1.05) - 1 / std::sqrt(0.95)) / 2,
              1e-3);
  EXPECT_NEAR(divide.first_order,
              std::abs(divide.effects[0].change) + std::abs(divide.effects[1].change), 1e-12);
  EXPECT_EQ(divide.range.machines, 200);
  EXPECT_EQ(divide.range.without, 0);
  const double lowest = std::sqrt(18 / 1.05), highest = std::sqrt(22 / 0.95);
  EXPECT_GT(divide.range.lowest, lowest);
  EXPECT_LT(divide.range.highest, highest);
  EXPECT_NEAR(divide.range.lowest, lowest, 0.2 * (omega - lowest));
  EXPECT_NEAR(divide.range.highest, highest, 0.2 * (highest - omega));
}

TEST(Uncertainty, IsNoneWithoutUncertainNumbersOrADivide) {
  EXPECT_FALSE(uncertain_divide(silent_below("0.2", "1"), silence, 4.47, 9, 1).has_value());
  const SceneFile file = silent_below("{value = 0.2, plus_minus = 0.02}", "1");
  EXPECT_FALSE(uncertain_divide(file, silence, 40, 9, 1).has_value());
}

}  // namespace
}  // namespace ricochet::carrier_track
