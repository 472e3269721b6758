#include "problems/carrier_track/paper/fitted_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/scene/scene_check.h"
#include "src/core/error.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

std::string complaint_about(const std::string& text) {
  try {
    parse_fitted_reading(text, "some.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FittedReading, OfTheDefaultIsAValidScene) {
  const FittedReading& fitted = default_reading();
  EXPECT_NO_THROW(check(fitted.scene, fitted.name));
  EXPECT_TRUE(is_one_scene(fitted.reading));
  EXPECT_FALSE(fitted.provenance.empty());
  EXPECT_LE(fitted.freed.size(), open_of(fitted.reading).size());
}

TEST(FittedReading, GivesEveryCaseTheSceneOfItsConstants) {
  const FittedReading& fitted = default_reading();
  for (const Case& c : all_cases()) {
    const Scene a = scene_of(c, fitted.scene);
    const Scene b = scene_of(c, fitted.reading, fitted.constants);
    EXPECT_EQ(a.restitution_lower, b.restitution_lower);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_EQ(a.disturbance, b.disturbance);
    EXPECT_EQ(a.pull, b.pull);
    EXPECT_EQ(a.contact_friction, b.contact_friction);
    EXPECT_EQ(a.start_position, b.start_position);
  }
}

TEST(FittedReading, IsWrittenAndReadBackBitForBit) {
  Reading reading;
  reading.tension = Tension::phased;
  Constants constants = natural_constants();
  constants[0] = 1.0 / 3.0;
  const auto fitted = fitted_reading(reading, constants, {Open::pull}, "a test", "here");
  const std::string text = write_fitted_reading(fitted);
  const FittedReading read = parse_fitted_reading(text, "there");
  EXPECT_EQ(read.reading, reading);
  EXPECT_EQ(read.constants[0], 1.0 / 3.0);
  ASSERT_EQ(read.freed.size(), 1U);
  EXPECT_EQ(read.freed[0], Open::pull);
  EXPECT_EQ(write_fitted_reading(read), text);
}

TEST(FittedReading, IsRefusedWithTheReason) {
  const std::string text = write_fitted_reading(default_reading());
  EXPECT_THAT(complaint_about("reading = 3"), HasSubstr("must be there"));
  EXPECT_THAT(complaint_about("reading = "), HasSubstr("not valid TOML"));
  EXPECT_THAT(complaint_about(text + "\nhope = 1\n"), HasSubstr("hope"));
  std::string missing = text;
  missing.replace(missing.find("clearance ="), 11, "slack =    ");
  EXPECT_THAT(complaint_about(missing), HasSubstr("clearance must be in one of"));
  std::string outside = text;
  outside.replace(outside.find("start_share ="), 13, "start_share = 7 #");
  EXPECT_THAT(complaint_about(outside), HasSubstr("start_share = 7: must be within 0..1"));
}

TEST(FittedReading, IsRefusedWhereCasesDifferInMore) {
  for (const char* name :
       {"projected-constant-revolutions-acceleration", "projected-constant-revolutions-crossing",
        "projected-constant-revolutions-hunt-crossley"}) {
    EXPECT_THROW(fitted_reading(find_reading(name), natural_constants(), {}, "", "here"),
                 InputError);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
