#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

nlohmann::json listed(const std::string& what) {
  const Outcome outcome = call("list " + what + " --format json");
  EXPECT_EQ(outcome.exit_code, 0);
  return nlohmann::json::parse(outcome.out);
}

TEST(List, HasTheTwelveCases) {
  const auto cases = listed("cases");
  ASSERT_EQ(cases.size(), 12U);
  EXPECT_EQ(cases[0]["case"], "C1");
  EXPECT_EQ(cases[0]["paper_threshold"], 9.0);
  EXPECT_TRUE(cases[10]["paper_threshold"].is_null());
}

TEST(List, HasEveryProblemWithItsBestValue) {
  const auto problems = listed("problems");
  ASSERT_EQ(problems.size(), 361U + 27 + 31 + 53);
  EXPECT_EQ(problems[0]["problem"], "count-C1");
  EXPECT_EQ(problems[0]["derivatives"], false);
  EXPECT_EQ(problems[12]["problem"], "surrogate-C1");
  EXPECT_EQ(problems[12]["derivatives"], true);
  EXPECT_EQ(problems[24]["constraints"], 1);
  for (const auto& problem : problems) {
    EXPECT_TRUE(problem["best_known"].is_number()) << problem["problem"];
  }
}

TEST(List, HasTheProblemsOfAMachineOfOnesOwn) {
  const auto file = write(fresh_folder(), "machine.toml", call("scene --case C1").out);
  const Outcome outcome = call("list problems --format json --scene " + file.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto problems = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(problems.size(), 30U);
  EXPECT_EQ(problems[0]["problem"], "count-scene");
  EXPECT_TRUE(problems[0]["best_known"].is_null());
  expect_refusal("list cases --scene " + file.string(), "--scene");
}

TEST(List, HasTheSolversWithTheirVersions) {
  const auto solvers = listed("solvers");
  EXPECT_GE(solvers.size(), 16U);
  for (const auto& solver : solvers) EXPECT_NE(solver["version"], "") << solver["solver"];
}

TEST(List, PrintsATableForPeople) {
  const Outcome outcome = call("list readings");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("reading"), 0U);
  EXPECT_NE(outcome.out.find("projected-constant-revolutions-weight"), std::string::npos);
}

TEST(List, RefusesWhatThereIsNot) {
  expect_refusal("list speeds", "speeds");
  expect_refusal("list", "what");
}

}  // namespace
}  // namespace ricochet::cli
