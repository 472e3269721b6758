#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "src/report/data_text.h"
#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

using report::Json;

TEST(Compare, WritesAReportOfEverySolverInEveryForm) {
  const auto folder = fresh_folder() / "mine";
  const Outcome outcome = call(
      "compare --questions top-speed-C1,profile-count-2-C4 --solvers 'nlopt-co*,random*,bisection' "
      "--budget 5,20 --instances 2 --out " +
      folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("top-speed, 20 evaluations a variable:"));
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "leaders.csv"));
  const Json data = report::data_in(read(folder / "data.json"));
  EXPECT_EQ(data["pages"], (Json{"top-speed", "profile-count"}));
  const Json family = report::data_in(read(folder / "top-speed" / "data.json"));
  std::set<std::string> cobyla;
  for (const Json& standing : family["standings"]) {
    if (standing["solver"] == "nlopt-cobyla") cobyla.insert(standing["form"].get<std::string>());
    EXPECT_EQ(standing["runs"], 2);
    EXPECT_LE(standing["found"]["lower"], standing["found"]["share"]);
  }
  EXPECT_EQ(cobyla, (std::set<std::string>{"count", "surrogate", "penalised-count",
                                           "penalised-surrogate"}));
  EXPECT_EQ(family["ceilings"].size(), 1U);
  EXPECT_FALSE(family["forms"].empty());
  EXPECT_FALSE(data["history"].empty());
  EXPECT_FALSE(data["twins"].empty());
}

TEST(Compare, ChoosesForms) {
  const auto folder = fresh_folder() / "mine";
  const Outcome outcome = call(
      "compare --questions top-speed-C1 --solvers nlopt-cobyla --forms '*count' --budget 5 "
      "--instances 1 --out " +
      folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json data = report::data_in(read(folder / "top-speed" / "data.json"));
  EXPECT_EQ(data["standings"].size(), 2U);
}

TEST(Compare, RefusesWhatNothingFits) {
  expect_refusal("compare --questions top-sped-C1", "--questions top-sped-C1: nothing fits");
  expect_refusal("compare --solvers coblya", "--solvers coblya: nothing fits");
  expect_refusal("compare --budget 20,10", "--budget 10");
  expect_refusal("compare --budget 0", "--budget 0");
  expect_refusal("compare --instances 0", "--instances 0");
  expect_refusal("compare --widths -1", "--widths -1");
}

}  // namespace
}  // namespace ricochet::cli
