#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "problems/carrier_track/scene/scene_fields.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

TEST(Quantity, IsInTheSiUnitWhateverUnitItIsGivenIn) {
  EXPECT_EQ(quantity("0.8 mm", "m"), 0.8e-3);
  EXPECT_EQ(quantity("80 um", "m"), 80e-6);
  EXPECT_EQ(quantity("6.5 cm", "m"), 6.5e-2);
  EXPECT_EQ(quantity("inf m", "m"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(quantity("1.2 kg", "kg"), 1.2);
  EXPECT_EQ(quantity("900 g", "kg"), 0.9);
  EXPECT_EQ(quantity("9.81 N", "N"), 9.81);
  EXPECT_EQ(quantity("-10 mN", "N"), -10e-3);
  EXPECT_EQ(quantity("5 mm/s", "m/s"), 5e-3);
  EXPECT_EQ(quantity("1.5 ms", "s"), 1.5e-3);
  EXPECT_EQ(quantity("2 min", "s"), 120.0);
  EXPECT_DOUBLE_EQ(quantity("30 deg", "rad").value(), pi / 6);
  EXPECT_DOUBLE_EQ(quantity("120 rpm", "rad/s").value(), 4 * pi);
  EXPECT_DOUBLE_EQ(quantity("2 Hz", "rad/s").value(), 4 * pi);
  EXPECT_DOUBLE_EQ(quantity("78 g m", "kg m").value(), 0.078);
  EXPECT_DOUBLE_EQ(quantity("0.33 kg mm", "kg m").value(), 3.3e-4);
  EXPECT_EQ(quantity("1e-3  kg", "kg"), 1e-3);  // two blanks
}

TEST(Quantity, NeedsNoBlank) {
  EXPECT_EQ(quantity("0.8mm", "m"), 0.8e-3);
  EXPECT_EQ(quantity("1kg", "kg"), 1.0);
  EXPECT_EQ(quantity("1e-3m", "m"), 1e-3);
  EXPECT_EQ(quantity("-5e3mN", "N"), -5.0);
  EXPECT_EQ(quantity("2.min", "s"), 120.0);
  EXPECT_EQ(quantity("infm", "m"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(quantity("5mm/s", "m/s"), 5e-3);
  EXPECT_DOUBLE_EQ(quantity("60rpm", "rad/s").value(), 2 * pi);
  EXPECT_DOUBLE_EQ(quantity("78g m", "kg m").value(), 0.078);
}

TEST(Quantity, IsNothingElse) {
  for (const char* text : {"",     " ",      "1",        "1 ",     "kg",     " 1 kg", "1kgm",
                           "1k g", "1e",     "1e kg",    "1..2kg", "1 kg ",  "1 KG",  "1 lb",
                           "1 m",  "1,2 kg", "1.2.3 kg", "one kg", "1 kg m", "0x1 kg"}) {
    EXPECT_FALSE(quantity(text, "kg").has_value()) << text;
  }
  EXPECT_FALSE(quantity("0.5 1", "1").has_value());
  EXPECT_FALSE(quantity("1 N", "N/m^contact_exponent").has_value());
}

/// What a new unit of a field must not forget.
TEST(Quantity, HasUnitsForEveryFieldThatHasADimension) {
  const auto expect_units = [](const SceneField& field) {
    if (field.unit.empty() || field.unit == "1" || field.unit.starts_with("N/m^")) return;
    ASSERT_THAT(units_for(field.unit), testing::SizeIs(testing::Ge(2U))) << field.key;
    EXPECT_EQ(units_for(field.unit).front(), field.unit);
  };
  visit_scene_fields(expect_units);
  visit_across_fields(expect_units);
  visit_count_fields(expect_units);
  visit_model_fields(expect_units);
  expect_units(path_radius);
}

}  // namespace
}  // namespace ricochet::carrier_track
