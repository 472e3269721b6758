#include <gmock/gmock.h>

#include "ricochet/error.h"
#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/studies/verification/verification.h"

namespace ricochet::studies {
namespace {

using report::Json;
using testing::HasSubstr;
using testing::Not;

/// Results as the study makes them, with two counts that are wrong.
Json failed_results() {
  const Json row = {{"name", "graze"},    {"scenes", 3},        {"broken_off", 0},
                    {"certain", 1.0},     {"wrong_certain", 1}, {"wrong_uncertain", 0},
                    {"missed", 1},        {"spurious", 0},      {"matched", 7},
                    {"time_error", 1e-9}, {"speed_error", 2e-9}};
  const Json speeds = {{"case", "C1"},         {"threshold", nullptr}, {"speeds", 10},
                       {"certain", 0.9},       {"compared", 1},        {"wrong_certain", 1},
                       {"wrong_uncertain", 0}, {"wrong_at", {0.1}}};
  return {{"made", {{"version", "1"}, {"compiler", "GCC"}, {"threads", 2}, {"seconds", 1.25}}},
          {"seed", 1},
          {"scenes", {row}},
          {"wrong", {2}},
          {"unmatched", {2}},
          {"quiet_speeds", {speeds}},
          {"failed", true}};
}

TEST(Verification, SaysWhichScenesAreWrong) {
  const auto drawing = report::drawn(report::page_template("verification"), failed_results());
  EXPECT_THAT(drawing.epilogue, HasSubstr("WRONG: the certain count of scene 2\n"));
  EXPECT_THAT(drawing.epilogue, HasSubstr("WRONG: C1 at 0.10 rad/s\n"));
  EXPECT_THAT(drawing.page.intro.back(), HasSubstr("There is a count called certain"));
  EXPECT_THAT(drawing.page.sections.front().paragraphs, testing::Contains("Wrong: scene 2"));
}

TEST(Verification, FindsNothingWrongAndSaysSo) {
  Json data = verification_study({.scenes = 60, .seed = 3}).compute(false);
  EXPECT_FALSE(data["failed"].get<bool>());
  EXPECT_EQ(data["scenes"].back()["scenes"], 60);
  EXPECT_GT(data["scenes"].back()["matched"], 100);
  EXPECT_EQ(data["quiet_speeds"].size(), 12U);
  data["made"] = failed_results()["made"];
  const auto drawing = report::drawn(report::page_template("verification"), data);
  EXPECT_THAT(drawing.page.intro.back(), HasSubstr("No count called certain is wrong"));
  EXPECT_THAT(drawing.epilogue, Not(HasSubstr("WRONG")));
}

TEST(Verification, RefusesNumbersThatMakeNoSense) {
  EXPECT_THROW(verification_study({.scenes = 0}), InputError);
}

}  // namespace
}  // namespace ricochet::studies
