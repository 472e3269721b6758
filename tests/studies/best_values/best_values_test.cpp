#include "src/studies/best_values/best_values.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "tests/studies/best_values/some_problems.h"

namespace ricochet::studies::best_values {
namespace {

using carrier_track::BestValues;

std::filesystem::path fresh_file() {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("ricochet-best-values-" +
                       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / "best.toml";
}

BestValues read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return carrier_track::parse_best_values({std::istreambuf_iterator<char>(stream), {}}, "file");
}

std::vector<Problem> problems() {
  return {{stairs()}, {speeds()}};
}

TEST(BestValues, MatchesByPartsAndByPatterns) {
  Problem first = stairs(), second = stairs();
  first.name = "profile-wear-8-C1";
  second.name = "profile-wear-8-C12";
  const auto matches = [&](const char* pattern) {
    return matching({first, second}, pattern).size();
  };
  EXPECT_EQ(matches(""), 2U);
  EXPECT_EQ(matches("wear"), 2U);
  EXPECT_EQ(matches("profile-*-C1"), 1U);
  EXPECT_THROW(matches("design"), InputError);
}

TEST(BestValues, AreProvenWhereACompleteScanLeavesNothingBetter) {
  Problem proven = stairs(), open = speeds(), untold = stairs();
  for (Problem* problem : {&proven, &open, &untold}) problem->best_known = -3;
  untold.best_known = {};
  untold.not_excluded = proven.not_excluded = [](double) { return std::vector<CoordinateRange>(); };
  open.not_excluded = [](double best) {
    return std::vector<CoordinateRange>{{-best, 3.25}, {3.5, 3.75}};
  };
  const Table table = proofs({proven, open, untold, cut_bowl()});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_TRUE(table[0].is("proven"));
  EXPECT_EQ(table[0].text("left"), "none");
  EXPECT_FALSE(table[1].is("proven"));
  EXPECT_EQ(table[1].text("left"), "3 to 3.25, 3.5 to 3.75");
}

TEST(BestValues, WritesTheBestValuesAndLeavesNothingElse) {
  const auto file = fresh_file();
  const Outcome outcome = find_best_values(problems(), {}, file);
  EXPECT_EQ(outcome.wanted, 2U);
  EXPECT_EQ(outcome.finished, 2U);
  EXPECT_EQ(outcome.improved, 2U);
  const BestValues values = read(file);
  EXPECT_EQ(values.of.at("stairs").value, -3);
  EXPECT_EQ(values.machine, carrier_track::default_machine_hash());
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(BestValues, GoesOnWhereItWasStopped) {
  const auto file = fresh_file();
  Plan plan;
  plan.problems = "stairs";
  find_best_values(problems(), plan, file);
  std::filesystem::rename(file, file.string() + ".part");  // as if it had been stopped then
  std::vector<Problem> all = problems();
  int evaluations = 0;
  all[0].evaluate = [&, evaluate = all[0].evaluate](const Vector& x) {
    ++evaluations;
    return evaluate(x);
  };
  const Outcome outcome = find_best_values(all, {}, file);
  EXPECT_EQ(outcome.finished, 2U);
  EXPECT_EQ(read(file).of.at("stairs").value, -3);
  EXPECT_LE(evaluations, 2) << "looked at, but not looked for again";
}

TEST(BestValues, KeepsWhatACallForOthersHasFinished) {
  const auto file = fresh_file();
  const std::filesystem::path part = file.string() + ".part";
  Plan plan;
  plan.problems = "stairs";
  find_best_values(problems(), plan, file);
  std::filesystem::rename(file, part);
  plan.problems = "speeds";
  find_best_values(problems(), plan, file);
  EXPECT_EQ(read(part).of.count("stairs"), 1U);
  EXPECT_EQ(read(part).of.count("speeds"), 0U);
}

TEST(BestValues, LooksAgainForWhatWasChanged) {
  const auto file = fresh_file();
  find_best_values(problems(), {}, file);
  const std::string whole = write_best_values(read(file));
  std::string changed = whole;
  changed.replace(changed.find("value = -3.0"), 12, "value = -99.0");
  std::filesystem::remove(file);
  write_text_file(file.string() + ".part", changed);
  find_best_values(problems(), {}, file);
  EXPECT_EQ(write_best_values(read(file)), whole);
}

TEST(BestValues, RefusesWhatIsOfAnotherMachine) {
  const auto file = fresh_file();
  write_text_file(file.string() + ".part", carrier_track::write_best_values({"sideways", {}}));
  EXPECT_THROW(find_best_values(problems(), {}, file), InputError);
}

TEST(BestValues, BeginsNothingWithoutTime) {
  const auto file = fresh_file();
  Plan plan;
  plan.seconds = -1;
  const Outcome outcome = find_best_values(problems(), plan, file);
  EXPECT_EQ(outcome.finished, 0U);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(BestValues, NeverReplacesABetterValueByAWorseOne) {
  const auto file = fresh_file();
  Plan plan;
  std::vector<Problem> known = problems();
  known[0].scan_step = 0.3;  // misses the best stair
  known[0].best_point = Vector::Constant(1, 2.003);
  known[0].best_known = -3;
  known[0].provenance = "by hand";
  const Outcome outcome = find_best_values(known, plan, file);
  EXPECT_EQ(outcome.improved, 1U);
  EXPECT_EQ(read(file).of.at("stairs").provenance, "by hand");
  // And once more from the file.
  find_best_values(problems(), plan, file);
  EXPECT_EQ(read(file).of.at("stairs").provenance, "by hand");
}

/// A value is worth what it is worth today.
TEST(BestValues, ForgetsAValueThatDoesNotComeOutAgain) {
  const auto file = fresh_file();
  std::vector<Problem> known = problems();
  known[0].best_point = Vector::Constant(1, 3.0);
  known[0].best_known = -100;
  known[0].provenance = "of another interpretation";
  find_best_values(known, {}, file);
  EXPECT_EQ(read(file).of.at("stairs").value, -3);
}

TEST(BestValues, RefusesAPatternThatNothingMatchesAndAFileThatIsNone) {
  const auto file = fresh_file();
  Plan plan;
  plan.problems = "nothing";
  EXPECT_THROW(find_best_values(problems(), plan, file), InputError);
  write_text_file(file, "no values");
  EXPECT_THROW(find_best_values(problems(), {}, file), InputError);
}

}  // namespace
}  // namespace ricochet::studies::best_values
