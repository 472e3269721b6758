#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// What the program is sent on standard input, and what it answers.
struct Dialogue {
  Outcome outcome;
  std::vector<json> answers;
};

Dialogue asked(const std::string& arguments, const std::string& lines) {
  const auto points = write(fresh_folder(), "points.jsonl", lines);
  Dialogue dialogue{call(fmt::format("evaluate {} <{}", arguments, points.string())), {}};
  std::istringstream out(dialogue.outcome.out);
  for (std::string line; std::getline(out, line);) dialogue.answers.push_back(json::parse(line));
  return dialogue;
}

/// The error of a line that holds no point of hs-71, which has four variables.
std::string error_of(const std::string& line) {
  const Dialogue dialogue = asked("hs-71", line + "\n[1, 1, 1, 1]\n");
  EXPECT_EQ(dialogue.outcome.exit_code, 1);
  EXPECT_EQ(dialogue.outcome.err, "");
  EXPECT_EQ(dialogue.answers.size(), 2U);
  if (dialogue.answers.size() != 2) return "";
  EXPECT_EQ(dialogue.answers[1]["evaluations"], 1) << "it goes on";
  return dialogue.answers[0].value("error", "");
}

/// hs-71: minimise x1 x4 (x1 + x2 + x3) + x3; sum of squares 40, product 25 at least.
TEST(Evaluate, AnswersEveryPoint) {
  const Dialogue dialogue = asked("hs-71", "[1, 5, 5, 1]\n{\"x\": [1, 2, 3, 4]}\n");
  EXPECT_EQ(dialogue.outcome.exit_code, 0) << dialogue.outcome.err;
  ASSERT_EQ(dialogue.answers.size(), 2U);
  const json& first = dialogue.answers[0];
  EXPECT_EQ(first["objective"], 16);
  EXPECT_EQ(first["constraints"], (json{12, 0}));
  EXPECT_EQ(first["true_values"], (json{{"objective", 16}, {"violation", 12}}));
  EXPECT_EQ(first["evaluations"], 1);
  EXPECT_FALSE(first.contains("gradient"));
  EXPECT_EQ(dialogue.answers[1]["objective"], 27);
  EXPECT_EQ(dialogue.answers[1]["evaluations"], 2);
}

/// The answer to a list has what the answers to its points have, in lists.
TEST(Evaluate, AnswersAListOfPointsByLists) {
  const std::string options = R"(, "derivatives": true})";
  const Dialogue one_by_one = asked("hs-71 --replay", R"({"x": [1, 5, 5, 1])" + options + "\n" +
                                                          R"({"x": [1, 2, 3, 4])" + options + "\n");
  const Dialogue at_once =
      asked("hs-71 --replay", R"({"x": [[1, 5, 5, 1], [1, 2, 3, 4]])" + options + "\n");
  EXPECT_EQ(at_once.outcome.exit_code, 0) << at_once.outcome.err;
  ASSERT_EQ(one_by_one.answers.size(), 2U);
  ASSERT_EQ(at_once.answers.size(), 1U);
  json expected;
  for (const json& answer : one_by_one.answers) {
    for (const auto& [key, value] : answer.items()) expected[key].push_back(value);
  }
  EXPECT_EQ(expected["objective"], (json{16, 27}));
  EXPECT_EQ(expected["same_again"], (json{true, true}));
  expected["evaluations"] = one_by_one.answers[1]["evaluations"];
  EXPECT_EQ(at_once.answers[0], expected);
}

TEST(Evaluate, TakesAListWithoutKeys) {
  const Dialogue dialogue = asked("hs-71", "[[1, 5, 5, 1], [1, 2, 3, 4]]\n[[1, 2, 3, 4]]\n");
  ASSERT_EQ(dialogue.answers.size(), 2U);
  EXPECT_EQ(dialogue.answers[0]["objective"], (json{16, 27}));
  EXPECT_EQ(dialogue.answers[0]["evaluations"], 2);
  EXPECT_EQ(dialogue.answers[1]["objective"], (json{27})) << "a list of one is a list";
  EXPECT_EQ(dialogue.answers[1]["evaluations"], 3);
}

TEST(Evaluate, EvaluatesNoPointOfAListWithABadOne) {
  EXPECT_EQ(error_of("[[1, 1, 1, 1], [1, 1]]"), "line 1: x must have 4 numbers in point 2");
  EXPECT_EQ(error_of("[[1, 1, 1, 1], 5]"), "line 1: x must have 4 numbers in point 2");
  EXPECT_EQ(error_of("[[1, 1, 1, 1], [1, 1, 1, null]]"), "line 1: x must have numbers, not null");
  EXPECT_EQ(error_of("[]"), "line 1: x must have 4 numbers");
  EXPECT_EQ(error_of("[[]]"), "line 1: x must have 4 numbers in point 1");
}

TEST(Evaluate, TellsDerivativesOfAllPointsOrOfSome) {
  const std::string with = R"({"x": [1, 2, 3, 4], "derivatives": true})";
  const std::string without = R"({"x": [1, 2, 3, 4], "derivatives": false})";
  const json gradient = {4 * 7, 4, 5, 6};
  const json jacobian = {{2, 4, 6, 8}, {-24, -12, -8, -6}};
  const Dialogue one = asked("hs-71", with + "\n[1, 2, 3, 5]\n");
  EXPECT_EQ(one.answers.at(0)["gradient"], gradient);
  EXPECT_EQ(one.answers.at(0)["jacobian"], jacobian);
  EXPECT_EQ(one.answers.at(0)["evaluations"], 5);
  EXPECT_FALSE(one.answers.at(1).contains("gradient"));
  const Dialogue other = asked("hs-71 --derivatives", "[1, 2, 3, 4]\n" + without + "\n");
  EXPECT_EQ(other.answers.at(0)["jacobian"], jacobian);
  EXPECT_FALSE(other.answers.at(1).contains("jacobian"));
}

TEST(Evaluate, TellsResidualsOfALeastSquaresProblem) {
  const std::string point = R"({"x": [1, 1, 1, 1, 1, 1, 1, 1, 1], "residuals": true)";
  const Dialogue dialogue = asked("least-squares-01-linear-full-rank-9x45",
                                  point + "}\n" + point + R"(, "derivatives": true})" + "\n");
  const json& values = dialogue.answers.at(0)["residuals"];
  double sum = 0;
  for (const json& value : values) sum += value.get<double>() * value.get<double>();
  EXPECT_EQ(values.size(), 45U);
  EXPECT_NEAR(sum, 2 * dialogue.answers.at(0)["objective"].get<double>(), 1e-12 * sum);
  EXPECT_EQ(dialogue.answers.at(0)["evaluations"], 2);
  EXPECT_FALSE(dialogue.answers.at(0).contains("residual_jacobian"));
  EXPECT_EQ(dialogue.answers.at(1)["residual_jacobian"].size(), 45U);
  EXPECT_THAT(error_of(R"({"x": [1, 1, 1, 1], "residuals": true})"),
              HasSubstr("there are no residuals in this formulation"));
}

TEST(Evaluate, IsTheCountOfTheSimulation) {
  const json simulated = json::parse(call("simulate --case C1 --omega 9 --format json").out);
  const Dialogue count = asked("count-C1", "[9]\n");
  EXPECT_EQ(count.answers.at(0)["objective"], simulated["count"]);
  const Dialogue smooth = asked("count-C1 --formulation surrogate", "[9]\n");
  EXPECT_EQ(smooth.answers.at(0)["objective"], simulated["surrogate"]);
  EXPECT_EQ(smooth.answers.at(0)["true_values"]["objective"], simulated["count"]);
}

TEST(Evaluate, ReadsBackTheBitsItWrote) {
  const Dialogue once = asked("profile-wear-8-C4", "[1.1, 2.3, 3.7, 4.1, 5.3, 6.1, 7.9, 0.1]\n");
  const Dialogue again = asked("profile-wear-8-C4 --replay", "[1.1,2.3,3.7,4.1,5.3,6.1,7.9,0.1]\n");
  EXPECT_EQ(once.answers.at(0)["objective"], again.answers.at(0)["objective"]);
  EXPECT_EQ(again.answers.at(0)["same_again"], true);
  EXPECT_EQ(again.answers.at(0)["evaluations"], 1);
  EXPECT_EQ(again.outcome.exit_code, 0);
}

TEST(Evaluate, DescribesTheProblem) {
  const Outcome outcome =
      call("evaluate top-speed-C1 --describe --formulation penalised-surrogate");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json described = json::parse(outcome.out);
  EXPECT_EQ(described["problem"], "top-speed-C1");
  EXPECT_EQ(described["formulation"], "penalised-surrogate");
  EXPECT_THAT(described["formulations"],
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate"));
  EXPECT_EQ(described["dimension"], 1);
  EXPECT_EQ(described["constraints"], 0);
  EXPECT_EQ(described["derivatives"], true);
  EXPECT_EQ(described["variables"], (json{{{"name", "speed"}, {"unit", "rad/s"}}}));
  EXPECT_EQ(described["lower"].size(), 1U);
  const json scanned = json::parse(call("threshold --case C1 --format json").out);
  EXPECT_NEAR(described["best_known"].get<double>(), -scanned["first_loud"].get<double>(), 0.002);
  EXPECT_EQ(described["best_point"], (json{-described["best_known"].get<double>()}));
  EXPECT_EQ(described["proven"], true);
  EXPECT_GT(described["penalty_weight"], 0);
  EXPECT_THAT(described["provenance"].get<std::string>(), HasSubstr("scan"));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
  const json moved = json::parse(call("evaluate top-speed-C1 --describe --instance 2").out);
  EXPECT_EQ(moved["best_known"], described["best_known"]);
  EXPECT_NE(moved["lower"], described["lower"]);
}

TEST(Evaluate, AsksAMachineOfYourOwnAtItsLevel) {
  const auto file = std::filesystem::path(testing::TempDir()) / "ricochet_evaluate_machine.toml";
  std::ofstream(file) << call("scene --case C4").out;
  const Dialogue mine = asked("count-scene --scene " + file.string(), "[9]\n");
  EXPECT_EQ(mine.outcome.exit_code, 0) << mine.outcome.err;
  EXPECT_EQ(mine.outcome.out, asked("count-C4", "[9]\n").outcome.out);
}

TEST(Evaluate, AsksAMachineWithSettings) {
  const std::string scene = " --scene " RICOCHET_SOURCE "/examples/machine.toml";
  const auto answer = [&](const std::string& settings) {
    return asked("count-scene" + scene + settings, "[7.0]\n").outcome.out;
  };
  EXPECT_NE(answer(""), answer(" --set restitution=0.9"));
  expect_refusal("evaluate count-C1 --set mass=2", "--set mass=2: changes a machine file");
}

TEST(Evaluate, GoesOnAfterABadLine) {
  const std::string point = "x must have 4 numbers";
  EXPECT_EQ(error_of("[1, 2, 3]"), "line 1: " + point);
  EXPECT_EQ(error_of("[1, 2, 3, 4, 5]"), "line 1: " + point);
  EXPECT_EQ(error_of("{\"x\": 1}"), "line 1: " + point);
  EXPECT_EQ(error_of("[1, 2, 3, \"4\"]"), "line 1: " + point + ": entry 4 is of type string");
  EXPECT_EQ(error_of("[1, 2, null, 4]"), "line 1: x must have numbers, not null");
  EXPECT_THAT(error_of("5"), StartsWith("line 1: must be a point, such as [1, 2]"));
  EXPECT_THAT(error_of("{\"y\": [1]}"), StartsWith("line 1: must be a point"));
  EXPECT_THAT(error_of("[1, 2, 3, NaN]"), StartsWith("line 1: is no JSON, from byte 11 on"));
  EXPECT_THAT(error_of("[1, 2, 3, 1e999]"), StartsWith("line 1: has a number that is too large"));
  EXPECT_THAT(error_of("[1, 2, 3, 4"), HasSubstr("is no JSON"));
  EXPECT_THAT(error_of("x = 1\xff\x1b"), HasSubstr("is no JSON"));
  EXPECT_THAT(error_of("{\"x\": [1, 1, 1, 1], \"derivative\": true}"),
              HasSubstr("derivative is not expected; did you mean derivatives?"));
  EXPECT_THAT(error_of("{\"x\": [1, 1, 1, 1], \"derivatives\": 1}"), HasSubstr("true or false"));
}

TEST(Evaluate, SaysWhichLineWasBad) {
  const Dialogue dialogue = asked("hs-71", "[1, 1, 1, 1]\n\n \t\r\n[1]\n[2, 2, 2, 2]");
  ASSERT_EQ(dialogue.answers.size(), 3U);
  EXPECT_EQ(dialogue.answers[1]["error"], "line 4: x must have 4 numbers");
  EXPECT_EQ(dialogue.answers[2]["evaluations"], 2) << "the last line needs no end";
}

TEST(Evaluate, SurvivesLongLines) {
  const std::string deep(500'000, '[');
  EXPECT_THAT(error_of(deep), HasSubstr("is no JSON"));
  EXPECT_THAT(error_of("[" + deep + std::string(500'000, ']') + "]"), HasSubstr("line 1: x must"));
  EXPECT_EQ(error_of("[" + std::string(5'000'000, '1') + "]"), "line 1: is longer than 4 MiB");
}

TEST(Evaluate, AnswersALineThatBeginsWithBlanksAndNoneThatIsBlank) {
  const std::string blank(5'000'000, ' ');
  EXPECT_EQ(error_of(blank + "[1, 1, 1, 1]"), "line 1: is longer than 4 MiB");
  EXPECT_EQ(error_of(blank + "[1, 1, 1, 1]" + blank), "line 1: is longer than 4 MiB");
  const Dialogue dialogue = asked("hs-71", blank + "\n[1, 1, 1, 1]\n");
  EXPECT_EQ(dialogue.outcome.exit_code, 0);
  EXPECT_EQ(dialogue.answers.size(), 1U);
}

TEST(Evaluate, HasNoAnswerButNullForWhatIsNoNumber) {
  const Dialogue dialogue = asked("hs-71", "[1e300, 1e300, 1e300, -1e308]\n");
  EXPECT_EQ(dialogue.outcome.exit_code, 0);
  EXPECT_TRUE(dialogue.answers.at(0)["objective"].is_number()) << "projected onto the box";
}

/// What a script of bash that calls $PROGRAM leaves behind.
Outcome call_from_bash(const std::string& script) {
  const auto file = write(fresh_folder(), "script", "PROGRAM=" RICOCHET_PROGRAM "\n" + script);
  return call("--version >/dev/null; bash " + file.string());
}

TEST(Evaluate, AnswersAtOnce) {
  const Outcome outcome = call_from_bash(R"(
coproc asked { "$PROGRAM" evaluate hs-71; }
echo '[1, 1, 1, 1]' >&"${asked[1]}"
read -r -t 20 -u "${asked[0]}" answer
echo "$answer"
exec {asked[1]}>&-
wait)");
  EXPECT_THAT(outcome.out, HasSubstr("\"evaluations\":1")) << outcome.err;
}

TEST(Evaluate, EndsWhereNobodyListens) {
  const auto point = write(fresh_folder(), "point", "[1, 1, 1, 1]");
  const Outcome full = call_with_output("evaluate hs-71 <" + point.string(), ">/dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, StartsWith("ricochet: standard output: "));
  const Outcome closed = call_from_bash(R"(
trap '' PIPE
{ yes '[1, 1, 1, 1]' 2>/dev/null | "$PROGRAM" evaluate hs-71; echo "${PIPESTATUS[1]}" >&2; } | head -n 1)");
  EXPECT_EQ(closed.err, "ricochet: standard output: Broken pipe\n1\n");
}

TEST(Evaluate, RefusesWhatIsNotThere) {
  expect_refusal("evaluate top-sped-C1 </dev/null", "top-sped-C1: there is no such problem");
  expect_refusal("evaluate hs-71 --formulation surrogate </dev/null",
                 "hs-71 has no such formulation; allowed");
  expect_refusal("evaluate hs-71 --instance -1 </dev/null", "--instance -1: must be >= 0");
  expect_refusal("evaluate count-C1 --derivatives </dev/null", "has none in formulation count");
  expect_refusal("evaluate count-scene --scene - </dev/null", "standard input holds the points");
  expect_refusal("evaluate count-scene --scene /nowhere.toml </dev/null", "/nowhere.toml");
  expect_refusal("evaluate hs-71 </tmp", "standard input: ");
  expect_refusal("evaluate hs-71 <&-", "standard input: ");
}

TEST(Evaluate, EndsWithNothingAsked) {
  const Outcome outcome = call("evaluate hs-71 </dev/null");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace ricochet::cli
