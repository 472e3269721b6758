#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/tool.h"

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

TEST(List, HasEveryProblemWithItsFormulationsAndItsBestValue) {
  const auto problems = listed("problems");
  ASSERT_EQ(problems.size(), 221U + 15 + 27 + 116 + 53 + 9);
  EXPECT_EQ(problems[0]["problem"], "count-C1");
  EXPECT_EQ(problems[0]["formulations"], (nlohmann::json{"count", "surrogate"}));
  EXPECT_EQ(problems[12]["problem"], "top-speed-C1");
  EXPECT_EQ(problems[12]["constraints"], 1);
  EXPECT_EQ(problems[12]["formulations"],
            (nlohmann::json{"count", "penalised-count", "surrogate", "penalised-surrogate"}));
  for (const auto& problem : problems) {
    EXPECT_TRUE(problem["best_known"].is_number()) << problem["problem"];
  }
  EXPECT_EQ(listed("problems"), problems);  // as they were called
}

TEST(List, HasTheProblemsOfAMachineOfOnesOwn) {
  const auto file = write(fresh_folder(), "machine.toml", call("scene --case C1").out);
  const Outcome outcome = call("list problems --format json --scene " + file.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto problems = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(problems.size(), 18U);
  EXPECT_EQ(problems[0]["problem"], "count-scene");
  EXPECT_TRUE(problems[0]["best_known"].is_null());
  expect_refusal("list cases --scene " + file.string(), "--scene");
}

TEST(List, HasTheProblemsOfAMachineWithSettings) {
  const std::string scene = "list problems --scene " RICOCHET_SOURCE "/examples/machine.toml";
  EXPECT_EQ(call(scene + " --set restitution=0.3").exit_code, 0);
  expect_refusal(scene + " --set restitution=3", "scene.restitution = 3: must be within 0..1");
  expect_refusal("list problems --set mass=2", "--set mass=2: changes a machine file");
  expect_refusal("list solvers --set mass=2", "--set");
}

TEST(List, HasTheSolversWithTheirVersions) {
  const auto solvers = listed("solvers");
  EXPECT_EQ(solvers.size(), 71U);
  for (const auto& solver : solvers) EXPECT_NE(solver["version"], "") << solver["solver"];
}

TEST(List, PrintsATableForPeople) {
  const Outcome outcome = call("list interpretations");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("interpretation"), 0U);
  EXPECT_NE(outcome.out.find("projected-constant-revolutions-weight"), std::string::npos);
}

/// The lines of a list on a terminal of that many columns.
std::vector<std::string> lines_on_terminal(const std::string& what, int columns) {
  const auto file = fresh_folder() / "screen";
  const int status =
      std::system(fmt::format("script -qec 'stty cols {} && {} list {}' /dev/null </dev/null >{}",
                              columns, RICOCHET_PROGRAM, what, file.string())
                      .c_str());
  EXPECT_EQ(status, 0);
  std::istringstream screen(read(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(screen, line);) {
    lines.push_back(line.substr(0, line.find('\r')));
  }
  return lines;
}

TEST(List, IsAsWideAsTheTerminal) {
  for (const char* what : {"cases", "problems", "solvers", "interpretations"}) {
    const auto whole = lines_on_terminal(what, 1000);
    const auto cut = lines_on_terminal(what, 60);
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
      EXPECT_EQ(cut[i], whole[i].size() <= 60 ? whole[i] : whole[i].substr(0, 57) + "...");
    }
  }
}

TEST(List, IsNeverCutElsewhere) {
  for (const char* what : {"cases", "problems", "solvers", "interpretations"}) {
    std::string whole;
    for (const std::string& line : lines_on_terminal(what, 1000)) whole += line + "\n";
    EXPECT_EQ(call(std::string("list ") + what).out, whole);
  }
  EXPECT_THAT(call("list interpretations").out, testing::Not(testing::HasSubstr("...")));
}

TEST(List, HasTheProblemsOfAFamilyAndThoseThatASolverAccepts) {
  const auto family = listed("problems --family top-speed");
  ASSERT_EQ(family.size(), 12U);
  EXPECT_EQ(family[0]["problem"], "top-speed-C1");
  const auto accepted = listed("problems --solver-accepts scan");
  ASSERT_GT(accepted.size(), 12U);
  for (const auto& problem : accepted) EXPECT_EQ(problem["dimension"], 1);
  expect_refusal("list problems --family top-sped", "did you mean top-speed");
  expect_refusal("list problems --solver-accepts ipot", "did you mean ipopt");
  expect_refusal("list cases --family top-speed", "--family");
}

TEST(List, RefusesWhatThereIsNot) {
  expect_refusal("list speeds", "speeds");
  expect_refusal("list", "what");
}

}  // namespace
}  // namespace ricochet::cli
