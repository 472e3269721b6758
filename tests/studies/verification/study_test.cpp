#include "ricochet/error.h"
#include "src/studies/verification/verification.h"
#include "tests/studies/pages.h"

namespace ricochet::studies {
namespace {

using carrier_track::Comparison;

Comparison comparison(bool certain, int count, int true_values) {
  Comparison c;
  c.certain = certain;
  c.count = count;
  c.true_values = true_values;
  c.matched = 2;
  c.time_error = 1e-9;
  return c;
}

TEST(Tally, SeparatesWrongCountsThatWereCalledCertainFromOthers) {
  const Comparison right = comparison(true, 3, 3), wrong = comparison(true, 3, 4);
  Comparison broken = wrong, unmatched = right;
  broken.compared = false;  // the oracle broke off
  unmatched.missed = 1;
  unmatched.time_error = 1;  // only of scenes whose impacts all match
  Table expected{"some", columns_named("scenes,number,capped,certain,wrong_certain,wrong_uncertain,"
                                       "matched,missed,time_error")};
  // Matched are those of scenes called certain.
  expected.add("some", 4, 0, 0.5, 1, 1, 4, 0, 1e-9);
  expected.add("some", 2, 1, 1.0, 0, 0, 2, 0, 1e-9);
  expected.add("some", 2, 0, 1.0, 0, 0, 4, 1, 1e-9);
  const std::vector<std::vector<Comparison>> all = {
      {right, wrong, comparison(false, 3, 4), comparison(false, 3, 3)},
      {broken, right},
      {unmatched, right}};
  std::vector<std::string> names;
  for (const Column& column : expected.columns) names.push_back(column.name);
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(only(tally("some", all[i]), names).rows.at(0), expected.rows[i]);
}

TEST(Verification, SaysWhichScenesAreWrong) {
  report::Results results;
  results.set("seed", 1);
  results.set("finding", "There is a count called certain that is wrong.");
  results.set("wrong", "WRONG: the certain count of: scene 2.");
  results.set("unmatched", std::optional<std::string>());
  results.set("wrong-speeds", "WRONG: the certain count of: C1 at 0.10 rad/s.");
  results.add(Table{"scenes"});
  results.add(Table{"quiet-speeds"});
  const StudyPage page = study_page("verification", results);
  EXPECT_THAT(page.files.at("summary.md"), HasSubstr("\nWRONG: the certain count of: scene 2.\n"));
  EXPECT_THAT(page.terminal, HasSubstr("C1 at 0.10 rad/s.\n"));
}

TEST(Verification, FindsNothingWrongAndSaysSo) {
  const report::Results results =
      report::results_in(verification_study({.scenes = 60, .seed = 3}).compute(false));
  EXPECT_EQ(*results.value("failed"), Value(false));
  const Table& scenes = *results.table("scenes");
  EXPECT_EQ(scenes[scenes.rows.size() - 1].number("number"), 60);
  EXPECT_GT(scenes[scenes.rows.size() - 1].number("matched"), 100);
  EXPECT_EQ(results.table("quiet-speeds")->rows.size(), 12U);
  const std::string text = study_page("verification", results).terminal;
  EXPECT_THAT(text, HasSubstr("No count called certain is wrong.\n"));
  EXPECT_THAT(text, Not(HasSubstr("WRONG")));
  EXPECT_THROW(verification_study({.scenes = 0}), InputError);
}

}  // namespace
}  // namespace ricochet::studies
