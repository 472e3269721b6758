#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/studies/machine/answer.h"
#include "tests/carrier_track/suite/planar_second_case.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using testing::HasSubstr;

QuietSpeedAnswer answer_for(const char* id, const QuietSpeedOptions& options,
                            double tolerance = 0) {
  return answer_quiet_speed("mine", scene_of(find_case(id), default_machine()), options, tolerance);
}

TEST(QuietSpeedAnswer, SaysWhatThereIsToSay) {
  const auto found = answer_for("C3", {});
  EXPECT_THAT(text_of(found), HasSubstr("mine: the fastest quiet speed is " +
                                        both_units(found.answer.fastest_quiet.value())));
  EXPECT_THAT(text_of(found), HasSubstr("In the long run: silent up to 2.877 rad/s"));
  EXPECT_THAT(text_of(found),
              HasSubstr(fmt::format("  {:.3f}  ", found.answer.split.first_loud.value())));
  const std::string window = text_of(answer_for("C3", {Limit{Measure::collisions, 3}, 1e-3, 18}));
  EXPECT_THAT(window, HasSubstr("significance"));
  EXPECT_THAT(window, HasSubstr("certain"));
  EXPECT_THAT(text_of(found), HasSubstr("Friction holds the carrier still up to"));
  EXPECT_THAT(text_of(answer_for("C1", {Limit{Measure::collisions, 6}, 1e-3, 10})),
              HasSubstr("The window of 1.38 turns is short: 2 of its 5 collisions at 8.0"));
  const auto rising = answer_quiet_speed("mine", planar_second_case(), {}, 0);
  EXPECT_THAT(text_of(rising), HasSubstr("mine: there is no threshold up to 18 rad/s"));
  const auto quiet = answer_for("C3", {Limit{Measure::collisions, 99}, 1e-3, 4});
  EXPECT_THAT(text_of(quiet), HasSubstr("mine: every speed up to 4 rad/s is quiet"));
  const auto loud = answer_for("C3", {Limit{Measure::collisions, 0}, 1e-3, 4});
  EXPECT_THAT(text_of(loud), HasSubstr("mine: loud at every speed up to 4 rad/s"));
  EXPECT_EQ(json_of(loud)["reason"], "loud at every speed");
  EXPECT_EQ(json_of(loud)["complete"], true);
}

TEST(QuietSpeedAnswer, IsTheSameInJson) {
  const auto answer = answer_for("C1", {Limit{Measure::collisions, 6}, 1e-3, 10}, 0.05);
  const report::Json json = json_of(answer);
  EXPECT_NEAR(json["fastest_quiet"], *answer.answer.fastest_quiet, 1e-8);
  EXPECT_EQ(json["limit"]["measure"], "collisions");
  EXPECT_EQ(json["steps"].size(), 2U);
  EXPECT_EQ(json["levels"].size(), 3U);
  EXPECT_EQ(json["around"].size(), 3U);
  EXPECT_NEAR(json["release_speed"], 1.43, 0.02);
  EXPECT_GE(json["start_collisions"], 1);
  EXPECT_NEAR(json["percent_for_one"]["restitution"], -0.8, 0.1);
  EXPECT_LT(json["with_tolerance"]["lowest"], json["fastest_quiet"]);
  EXPECT_GT(json["with_tolerance"]["highest"], json["fastest_quiet"]);
  EXPECT_TRUE(json["regimes"].empty());
  const report::Json rising = json_of(answer_quiet_speed("mine", planar_second_case(), {}, 0));
  EXPECT_TRUE(rising["limit"].is_null());
  const report::Json long_run = json_of(answer_for("C2", {}));
  EXPECT_EQ(long_run["limit"]["measure"], "collisions_per_turn");
  EXPECT_EQ(long_run["regimes"][0]["ends_by"], "release");
  EXPECT_TRUE(long_run["steps"].empty());
}

}  // namespace
}  // namespace ricochet::studies::advice
