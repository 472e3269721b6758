#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "src/report/data_text.h"
#include "tests/cli/tool.h"

/// Solvers that a user brings along, by the examples.
namespace ricochet::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string library = RICOCHET_EXAMPLE_LIBRARY;

/// How an example in Python is called.
std::string python(const std::string& name) {
  return fmt::format("\"" RICOCHET_PYTHON " " RICOCHET_SOURCE "/examples/solvers/{}.py\"", name);
}

bool python_has(const std::string& module) {
  return std::system((RICOCHET_PYTHON " -c 'import " + module + "' 2>/dev/null").c_str()) == 0;
}

json run_of(const std::string& arguments) {
  const Outcome outcome = call("solve --format json " + arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  json run = json::parse(outcome.out, nullptr, false);
  run.erase("seconds");
  return run;
}

/// Expects that the solver does the same twice, spends what it is given, and no more.
void expect_a_good_run(const std::string& solver, const std::string& problem, int budget) {
  const std::string call = fmt::format("{} {} --instance 1 --budget {}", solver, problem, budget);
  const json run = run_of(call);
  EXPECT_EQ(run["failure"], "") << solver;
  EXPECT_EQ(run["evaluations"], budget) << solver;
  EXPECT_EQ(run["terminations"].back(), "stopped by the evaluator") << solver;
  EXPECT_EQ(run, run_of(call)) << solver;
}

TEST(OwnSolver, IsALibrary) {
  expect_a_good_run(library, "classic-sphere-5", 2000);
  EXPECT_EQ(run_of(library + " classic-sphere-5 --budget 2000")["solved"], true);
  EXPECT_EQ(run_of(library + " hs-71")["formulation"], "penalised") << "it takes no constraints";
}

TEST(OwnSolver, IsAProgram) {
  if (!python_has("json")) GTEST_SKIP() << "no Python";
  expect_a_good_run(python("hill_climber"), "classic-sphere-5", 2000);
  const json run = run_of(python("hill_climber") + " classic-sphere-5 --budget 2000");
  EXPECT_EQ(run["solver"], "hill-climber");
  EXPECT_EQ(run["solved"], true);
  EXPECT_EQ(run["returned_solved"], true);
}

TEST(OwnSolver, IsOneOfScipy) {
  if (!python_has("scipy")) GTEST_SKIP() << "no python3-scipy";
  const std::string solver = python("scipy_differential_evolution");
  expect_a_good_run(solver, "classic-sphere-5", 300);
  EXPECT_EQ(run_of(solver + " count-C1 --budget 200")["solver"], "scipy-differential-evolution");
}

TEST(OwnSolver, IsOneOfNloptInPython) {
  if (!python_has("nlopt")) GTEST_SKIP() << "no python3-nlopt";
  const std::string solver = python("nlopt_cobyla");
  expect_a_good_run(solver, "hs-71", 300);
  const json run = run_of(solver + " hs-71 --budget 1000");
  EXPECT_EQ(run["formulation"], "original") << "with its constraints, an equality among them";
  EXPECT_NEAR(run["objective"].get<double>(), 17.014, 0.01);
}

TEST(OwnSolver, IsComparedWithOthers) {
  if (!python_has("json")) GTEST_SKIP() << "no Python";
  const auto folder = fresh_folder() / "mine";
  const std::string arguments = fmt::format(
      "compare --solver {} --solver {} --solver scan --solvers 'nlopt-crs*' "
      "--problems count-C1 --formulations count --budget 20 --instances 2 --out {}",
      library, python("hill_climber"), folder.string());
  const Outcome outcome = call(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const report::Json data = report::data_in(read(folder / "count" / "data.json"));
  std::set<std::string> names;
  for (const report::Json& result : data["results"]) {
    names.insert(result["solver"].get<std::string>());
    EXPECT_EQ(result["failed"], 0);
  }
  EXPECT_EQ(names, (std::set<std::string>{"mine", "hill-climber", "scan", "nlopt-crs2"}));
}

/// Expects a good run of an example in another language; skips where that is not installed.
void expect_of_language(const std::string& probe, const std::string& solver) {
  if (std::system((probe + " >/dev/null 2>&1").c_str()) != 0) GTEST_SKIP() << probe << " fails";
  expect_a_good_run("\"" + solver + "\"", "classic-sphere-5", 300);
  EXPECT_EQ(run_of("\"" + solver + "\" count-C1 --budget 50")["evaluations"], 50);
}

TEST(OwnSolver, InOctaveSpendsItsBudget) {
  expect_of_language("octave-cli --version", "octave-cli --quiet --no-init-file " RICOCHET_SOURCE
                                             "/examples/solvers/random_search.m");
}

TEST(OwnSolver, InRSpendsItsBudget) {
  expect_of_language("Rscript -e 'library(jsonlite)'",
                     "Rscript " RICOCHET_SOURCE "/examples/solvers/random_search.R");
}

TEST(OwnSolver, IsRefusedInOneLine) {
  expect_refusal("solve ./nothing.so count-C1", "./nothing.so: cannot open shared object file");
  expect_refusal("solve ./nothing count-C1", "./nothing: there is no such file");
  expect_refusal("solve 'no-such-program mine.py' count-C1", "exit code 127");
  expect_refusal("solve 'echo hello' count-C1", "echo hello: output line 1 is no JSON");
  expect_refusal(fmt::format("compare --solver {0} --solver {0}", library),
                 "there is another solver of its name, mine");
  expect_refusal("compare --solver coblya", "--solver coblya: there is no such solver");
}

TEST(OwnSolver, ThatFailsIsSaidTo) {
  const auto folder = fresh_folder();
  write(folder, "mine.sh", "echo '{\"name\": \"mine\"}'; read -r problem; echo oops");
  const std::string arguments = "\"sh " + (folder / "mine.sh").string() + "\" count-C1";
  const Outcome outcome = call("solve --format json " + arguments);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("mine.sh: output line 2 is no JSON"));
  const json run = json::parse(outcome.out);
  EXPECT_THAT(run["failure"].get<std::string>(), HasSubstr("mine.sh: output line 2 is no JSON"));
  const Outcome words = call("solve " + arguments);
  EXPECT_EQ(words.exit_code, 1);
  EXPECT_THAT(words.out, HasSubstr("no start ended."));
}

TEST(OwnSolver, ThatHangsEndsWithRicochet) {
  const auto folder = fresh_folder();
  write(folder, "mine.sh",
        fmt::format("echo $$ > {}/pid; echo '{{\"name\": \"mine\"}}'; read -r problem\n"
                    "while :; do :; done",
                    folder.string()));
  const Outcome outcome =
      call_interrupted("INT", "solve \"sh " + (folder / "mine.sh").string() + "\" count-C1");
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "ricochet: interrupted\n");
  const pid_t pid = std::stoi(read(folder / "pid"));
  for (int wait = 0; wait < 100 && kill(pid, 0) == 0; ++wait) usleep(100'000);
  EXPECT_NE(kill(pid, 0), 0) << "it goes on";
}

}  // namespace
}  // namespace ricochet::cli
