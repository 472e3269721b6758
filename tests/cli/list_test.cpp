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

TEST(List, HasFourProblemsForEveryCase) {
  const auto problems = listed("problems");
  ASSERT_EQ(problems.size(), 48U);
  EXPECT_EQ(problems[0]["problem"], "count-C1");
  EXPECT_EQ(problems[0]["derivatives"], false);
  EXPECT_EQ(problems[1]["derivatives"], true);
  EXPECT_EQ(problems[2]["constraints"], 1);
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
