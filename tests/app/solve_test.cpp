#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(Solve, RunsOneSolverAndJudgesIt) {
  const Outcome outcome = call("solve bisection top-speed-C1 --budget 30 --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["solved"], true);
  EXPECT_EQ(result["formulation"], "count");
  const json scanned = json::parse(call("threshold --case C1 --format json").out);
  EXPECT_NEAR(result["point"][0].get<double>(), scanned["first_loud"].get<double>(), 0.01);
  EXPECT_LE(result["evaluations"], 30);
  EXPECT_EQ(result["returned_solved"], true);
}

TEST(Solve, SaysTheSameInWords) {
  const Outcome outcome = call("solve bisection top-speed-C1 --budget 30");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("bisection on top-speed-C1, formulation count, instance 0: solved"));
  const json same = json::parse(call("solve bisection top-speed-C1 --budget 30 --format json").out);
  const std::string speed = std::to_string(same["point"][0].get<double>());
  EXPECT_THAT(outcome.out, HasSubstr("Returned: " + speed.substr(0, 6)));
}

TEST(Solve, SaysWhatIsMaximisedWithItsUnitAndWithoutASign) {
  for (const std::string problem : {"top-speed-C1", "hard-top-speed-01", "robust-worst-C4"}) {
    const Outcome outcome = call("solve random-search " + problem + " --budget 30");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                testing::ContainsRegex("Best evaluated: [0-9.]+ rad/s, [0-9.e-]+ from the best "
                                       "known, [0-9.]+ rad/s\\.\nReturned: [0-9.]+ rad/s\\.\n"));
  }
  const json data =
      json::parse(call("solve random-search top-speed-C1 --budget 30 --format json").out);
  EXPECT_LT(data["objective"], 0) << "as minimised";
}

/// The value beside a point is that of the problem as it is stated at that point, also where the
/// solver had another box or other coordinates.
TEST(Solve, SaysTheBestPointAsTheProblemHasIt) {
  for (const std::string problem : {"count-C2", "top-speed-C1", "profile-wear-8-C1",
                                    "design-count-C1", "classic-rosenbrock-5", "hs-26"}) {
    for (const std::string how :
         {"--instance 0", "--instance 2", "--instance 3 --perturbation reflected"}) {
      const std::string command =
          "solve random-search " + problem + " --budget 30 " + how + " --format json";
      const json told = json::parse(call(command).out);
      const auto point = write(fresh_folder(), "point", told["stated_point"].dump());
      const json stated = json::parse(call("evaluate " + problem + " <" + point.string()).out);
      const double objective = stated["true_values"]["objective"];
      EXPECT_NEAR(told["objective"].get<double>(), objective, 1e-9 * (1 + std::abs(objective)))
          << command;
      EXPECT_EQ(told["point"] == told["stated_point"], how == "--instance 0") << command;
    }
  }
}

TEST(Solve, ShowsThePointThatBelongsToItsValue) {
  const Outcome outcome = call("solve bisection top-speed-C1 --budget 30 --instance 2");
  std::smatch said;
  ASSERT_TRUE(std::regex_search(
      outcome.out, said, std::regex("Best evaluated: ([0-9.]+) rad/s[^]*point: ([0-9.]+)\\.\n")));
  EXPECT_EQ(said[1], said[2]);
  EXPECT_THAT(outcome.out, HasSubstr("In the solver's own box: "));
  EXPECT_THAT(call("solve bisection top-speed-C1 --budget 30").out,
              testing::Not(HasSubstr("own box")));
}

TEST(Solve, IsAnotherRunWithAnotherSeedAndTheSameWithTheSame) {
  const std::string command = "solve random-search top-speed-C1 --budget 30 --format json --seed ";
  const auto point = [&](const char* seed) {
    return json::parse(call(command + seed).out)["point"];
  };
  EXPECT_EQ(point("1"), point("1"));
  EXPECT_NE(point("1"), point("2"));
}

TEST(Solve, DisturbsWhatIsShownAndNotWhatIsJudged) {
  const std::string command = "solve random-search classic-sphere-5 --budget 50 --format json ";
  const json plain = json::parse(call(command).out);
  EXPECT_EQ(plain["perturbation"], "plain");
  const json noisy = json::parse(call(command + "--perturbation noisy").out);
  EXPECT_EQ(noisy["perturbation"], "noisy");
  double squares = 0;
  for (const double x : noisy["point"].get<std::vector<double>>()) squares += x * x;
  EXPECT_NEAR(noisy["objective"], squares, 1e-9 * squares) << "the noise would be 1e-3";
  const json turned = json::parse(call(command + "--perturbation reflected").out);
  EXPECT_NE(turned["point"], plain["point"]);
  const Outcome words =
      call("solve random-search classic-sphere-5 --budget 50 --perturbation noisy");
  EXPECT_THAT(words.out, HasSubstr("formulation original, noisy, instance 0"));
}

TEST(Solve, WritesTraceAndPicture) {
  const auto folder = fresh_folder();
  const Outcome outcome =
      call("solve fireworks profile-count-8-C4 --budget 100 --trace " +
           (folder / "trace.csv").string() + " --plot " + (folder / "trace.svg").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read(folder / "trace.csv"),
              testing::StartsWith("evaluations,seconds,objective,violation,x1,x2,"));
  EXPECT_THAT(read(folder / "trace.svg"), HasSubstr("best true objective"));
  const auto speeds = folder / "speeds.svg";
  ASSERT_EQ(call("solve scan top-speed-C1 --budget 30 --plot " + speeds.string()).exit_code, 0);
  EXPECT_THAT(read(speeds), HasSubstr("best true objective [rad/s]"));
}

TEST(Solve, TakesNamesInAnyCase) {
  const Outcome outcome = call("solve BISECTION top-speed-c1 --budget 30 --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["problem"], "top-speed-C1");
}

TEST(Solve, SaysByHowMuchAPointIsNotFeasible) {
  const std::string out = call("solve nlopt-cobyla hs-71 --budget 1").out;
  EXPECT_THAT(out, HasSubstr("Best evaluated point, not feasible by "));
  EXPECT_THAT(out, HasSubstr("Returned: a point that is not feasible, by "));
}

TEST(Solve, AsksTheProblemsOfAMachineOfOnesOwn) {
  const std::string scene = "--scene " RICOCHET_SOURCE "/examples/machine.toml";
  const Outcome outcome = call("solve nlopt-slsqp profile-wear-8-scene --budget 100 " + scene);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("on profile-wear-8-scene, formulation original, "
                                              "instance 0: not scored, as no best value is known"));
  EXPECT_NE(
      outcome.out,
      call("solve nlopt-slsqp profile-wear-8-scene --budget 100 --set restitution=0.2 " + scene)
          .out);
  expect_refusal("solve nlopt-slsqp count-C1 " + scene, "there is no such problem");
  expect_refusal("solve nlopt-slsqp count-scene --set mass=0 " + scene,
                 "machine.toml with --set mass=0: scene.mass = 0");
  expect_refusal("solve nlopt-slsqp count-C1 --set mass=2", "--set mass=2: changes a machine file");
}

TEST(Solve, RefusesWhatIsNotThere) {
  expect_refusal("solve coblya top-speed-C1", "coblya: there is no such solver");
  expect_refusal("solve scan top-sped-C1", "top-sped-C1: there is no such problem");
  expect_refusal("solve zzzzzz top-speed-C1", "no such solver; see `ricochet list solvers`");
  expect_refusal("solve scan zzzzzz", "no such problem; see `ricochet list problems`");
  expect_refusal("solve bisection top-speed-C1 --formulation penalised",
                 "there is no such formulation");
  expect_refusal("solve bisection count-C1", "accepts no formulation of count-C1");
  expect_refusal("solve scan count-C1 --perturbation noise",
                 "noise: there is no such perturbation");
  expect_refusal("solve scan count-C1 --perturbation permuted",
                 "--perturbation permuted: does not apply to count-C1, formulation count");
  expect_refusal("solve scan count-C1 --budget 0", "--budget 0");
  expect_refusal("solve scan count-C1 --budget 99999999999999999999",
                 "must be within 1..1000000000");
  expect_refusal("solve scan count-C1 --instance -1", "--instance -1");
}

}  // namespace
}  // namespace ricochet::cli
