#include <gmock/gmock.h>

#include "ricochet/error.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/studies/verification/verification.h"

namespace ricochet::studies {
namespace {

using report::Json;
using testing::HasSubstr;
using testing::Not;

TEST(Verification, SaysWhichScenesAreWrong) {
  report::Results results;
  results.set("seed", 1);
  results.set("finding", "There is a count called certain that is wrong.");
  results.set("wrong", "WRONG: the certain count of: scene 2.");
  results.set("unmatched", std::optional<std::string>());
  results.set("wrong-speeds", "WRONG: the certain count of: C1 at 0.10 rad/s.");
  results.add(Table{"scenes"});
  results.add(Table{"quiet-speeds"});
  for (const char* name : {"version", "compiler", "threads", "seconds", "date"})
    results.set(std::string("made.") + name, "1");
  const auto page = report::page_source(report::page_template("verification"));
  EXPECT_THAT(filled_page(page, results), HasSubstr("\nWRONG: the certain count of: scene 2.\n"));
  EXPECT_THAT(terminal_text(page, results), HasSubstr("C1 at 0.10 rad/s.\n"));
}

TEST(Verification, FindsNothingWrongAndSaysSo) {
  const Json data = verification_study({.scenes = 60, .seed = 3}).compute(false);
  const report::Results results = report::results_in(data);
  EXPECT_EQ(*results.value("failed"), Value(false));
  const Table& scenes = *results.table("scenes");
  EXPECT_EQ(scenes[scenes.rows.size() - 1].number("number"), 60);
  EXPECT_GT(scenes[scenes.rows.size() - 1].number("matched"), 100);
  EXPECT_EQ(results.table("quiet-speeds")->rows.size(), 12U);
  const auto page = report::page_source(report::page_template("verification"));
  const std::string text = terminal_text(page, results);
  EXPECT_THAT(text, HasSubstr("No count called certain is wrong.\n"));
  EXPECT_THAT(text, Not(HasSubstr("WRONG")));
}

TEST(Verification, RefusesNumbersThatMakeNoSense) {
  EXPECT_THROW(verification_study({.scenes = 0}), InputError);
}

}  // namespace
}  // namespace ricochet::studies
