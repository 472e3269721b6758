#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;

std::string complaint_about(const std::string& text) {
  try {
    parse_fitted_interpretation(text, "some.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FittedInterpretation, OfTheDefaultIsAValidScene) {
  const FittedInterpretation& fitted = default_interpretation();
  EXPECT_NO_THROW(check(fitted.scene, fitted.name));
  EXPECT_TRUE(is_one_scene(fitted.interpretation));
  EXPECT_FALSE(fitted.provenance.empty());
  EXPECT_LE(fitted.free.size(), unknowns_of(fitted.interpretation).size());
}

TEST(FittedInterpretation, GivesEveryCaseTheSceneOfItsConstants) {
  const FittedInterpretation& fitted = default_interpretation();
  for (const Case& c : all_cases()) {
    const Scene a = scene_of(c, fitted.scene);
    const Scene b = scene_of(c, fitted.interpretation, fitted.constants);
    EXPECT_EQ(a.restitution_lower, b.restitution_lower);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_EQ(a.disturbance, b.disturbance);
    EXPECT_EQ(a.pull, b.pull);
    EXPECT_EQ(a.contact_friction, b.contact_friction);
    EXPECT_EQ(a.start_position, b.start_position);
  }
}

TEST(FittedInterpretation, IsWrittenAndReadBackBitForBit) {
  Interpretation interpretation;
  interpretation.tension = Tension::phased;
  Constants constants = natural_constants();
  constants[0] = 1.0 / 3.0;
  const auto fitted =
      fitted_interpretation({interpretation, {Unknown::pull}, constants}, "a test", "here");
  const std::string text = write_fitted_interpretation(fitted);
  const FittedInterpretation read = parse_fitted_interpretation(text, "there");
  EXPECT_EQ(read.interpretation, interpretation);
  EXPECT_EQ(read.constants[0], 1.0 / 3.0);
  ASSERT_EQ(read.free.size(), 1U);
  EXPECT_EQ(read.free[0], Unknown::pull);
  EXPECT_EQ(write_fitted_interpretation(read), text);
}

TEST(FittedInterpretation, IsRefusedWithTheReason) {
  const std::string text = write_fitted_interpretation(default_interpretation());
  EXPECT_THAT(complaint_about("interpretation = 3"),
              HasSubstr("interpretation = 3: must be a text"));
  EXPECT_THAT(complaint_about(""), HasSubstr("some.toml: interpretation is missing"));
  EXPECT_THAT(complaint_about("interpretation = "), HasSubstr("not valid TOML"));
  EXPECT_THAT(complaint_about(text + "\nhope = 1\n"), HasSubstr("hope"));
  std::string missing = text;
  missing.replace(missing.find("clearance ="), 11, "slack =    ");
  EXPECT_THAT(complaint_about(missing), HasSubstr("clearance must be in one of"));
  std::string outside = text;
  outside.replace(outside.find("start_share ="), 13, "start_share = 7 #");
  EXPECT_THAT(complaint_about(outside), HasSubstr("fixed.start_share = 7: must be within 0..1"));
}

TEST(FittedInterpretation, IsRefusedWhereCasesDifferInMore) {
  for (const char* name :
       {"projected-constant-revolutions-acceleration", "projected-constant-revolutions-crossing",
        "projected-constant-revolutions-hunt-crossley"}) {
    EXPECT_THROW(
        fitted_interpretation({find_interpretation(name), {}, natural_constants()}, "", "here"),
        InputError);
  }
}

TEST(FittedInterpretation, OfTheDefaultIsTheDefaultMachine) {
  EXPECT_EQ(write_scene(default_interpretation().scene), write_scene(default_machine()));
}

}  // namespace
}  // namespace ricochet::carrier_track
