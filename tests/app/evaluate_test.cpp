#include "tests/app/tool.h"
#include "tests/support/test.h"

namespace ricochet::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What the program is sent on standard input, and what it answers.
struct Dialogue {
  Outcome outcome;
  std::vector<Json> answers;
};

Dialogue asked(const std::string& arguments, const std::string& lines) {
  write("points", lines);
  const Outcome outcome = call("evaluate {} <points", arguments);
  return {outcome, json_lines(outcome.out)};
}

/// The answer to one line, which must be the only one.
Json answer(const std::string& arguments, const std::string& line) {
  const Dialogue dialogue = asked(arguments, line + "\n");
  EXPECT_EQ(dialogue.outcome.exit_code, 0) << dialogue.outcome.err;
  EXPECT_EQ(dialogue.answers.size(), 1U);
  return dialogue.answers.at(0);
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

/// hs-71: minimise x1 x4 (x1 + x2 + x3) + x3; sum of squares 40, product 25 at least. Derivatives
/// are of all points or of some.
TEST(Evaluate, AnswersEveryPoint) {
  const std::string with = R"({"x": [1, 2, 3, 4], "derivatives": true})";
  const std::string without = R"({"x": [1, 2, 3, 4], "derivatives": false})";
  const Json first = Json::parse(R"({"objective": 16, "constraints": [12, 0],
                           "true_values": {"objective": 16, "violation": 12}, "evaluations": 1})");
  const Json plain = Json::parse(R"({"objective": 27, "constraints": [-10, 1],
                           "true_values": {"objective": 27, "violation": 10}, "evaluations": 2})");
  const Json exact = Json::parse(R"({"objective": 27, "constraints": [-10, 1],
      "gradient": [28, 4, 5, 6], "jacobian": [[2, 4, 6, 8], [-24, -12, -8, -6]],
      "true_values": {"objective": 27, "violation": 10}, "evaluations": 6})");  // the values were
                                                                                // known
  EXPECT_THAT(asked("hs-71", "[1, 5, 5, 1]\n" + without + "\n" + with + "\n").answers,
              ElementsAre(first, plain, exact));
  const Dialogue all = asked("hs-71 --derivatives", "[1, 2, 3, 4]\n" + without + "\n");
  EXPECT_EQ(all.answers.at(0)["jacobian"], exact["jacobian"]);
  EXPECT_FALSE(all.answers.at(1).contains("jacobian"));
}

/// The answer to a list has what the answers to its points have, in lists.
TEST(Evaluate, AnswersAListOfPointsByLists) {
  const std::string options = R"(, "derivatives": true})";
  const std::vector<Json> one_by_one =
      asked("hs-71 --replay",
            R"({"x": [1, 5, 5, 1])" + options + "\n" + R"({"x": [1, 2, 3, 4])" + options + "\n")
          .answers;
  ASSERT_EQ(one_by_one.size(), 2U);
  Json expected;
  for (const Json& one : one_by_one) {
    for (const auto& [key, value] : one.items()) expected[key].push_back(value);
  }
  EXPECT_EQ(expected["objective"], (Json{16, 27}));
  EXPECT_EQ(expected["same_again"], (Json{true, true}));
  expected["evaluations"] = one_by_one[1]["evaluations"];
  EXPECT_EQ(answer("hs-71 --replay", R"({"x": [[1, 5, 5, 1], [1, 2, 3, 4]])" + options), expected);
  EXPECT_EQ(answer("hs-71", "[[1, 5, 5, 1], [1, 2, 3, 4]]")["objective"], (Json{16, 27}));
  EXPECT_EQ(answer("hs-71", "[[1, 2, 3, 4]]")["objective"], Json::array({27}));
}

TEST(Evaluate, TellsResidualsOfALeastSquaresProblem) {
  const std::string point = R"({"x": [1, 1, 1, 1, 1, 1, 1, 1, 1], "residuals": true)";
  const Dialogue dialogue = asked("least-squares-01-linear-full-rank-9x45",
                                  point + "}\n" + point + R"(, "derivatives": true})" + "\n");
  const Json& first = dialogue.answers.at(0);
  double sum = 0;
  for (const Json& value : first["residuals"]) sum += value.get<double>() * value.get<double>();
  EXPECT_EQ(first["residuals"].size(), 45U);
  EXPECT_NEAR(sum, 2 * first["objective"].get<double>(), 1e-12 * sum);
  EXPECT_EQ(first["evaluations"], 2);
  EXPECT_FALSE(first.contains("residual_jacobian"));
  EXPECT_EQ(dialogue.answers.at(1)["residual_jacobian"].size(), 45U);
}

TEST(Evaluate, IsTheCountOfTheSimulation) {
  const Json simulated = json_of("simulate --case C1 --omega 9");
  EXPECT_EQ(answer("count-C1", "[9]")["objective"], simulated["count"]);
  const Json smooth = answer("count-C1 --formulation surrogate", "[9]");
  EXPECT_EQ(smooth["objective"], simulated["surrogate"]);
  EXPECT_EQ(smooth["true_values"]["objective"], simulated["count"]);
}

TEST(Evaluate, ReadsBackTheBitsItWrote) {
  const std::string point = "[1.1, 2.3, 3.7, 4.1, 5.3, 6.1, 7.9, 0.1]";
  const Json again = answer("profile-wear-8-C4 --replay", point);
  EXPECT_EQ(again["objective"], answer("profile-wear-8-C4", point)["objective"]);
  EXPECT_EQ(again["same_again"], true);
  EXPECT_EQ(again["evaluations"], 1);
}

TEST(Evaluate, DescribesTheProblem) {
  const Json described =
      Json::parse(out_of("evaluate top-speed-C1 --describe --formulation penalised-surrogate"));
  EXPECT_EQ(described["formulation"], "penalised-surrogate");
  EXPECT_THAT(described["formulations"],
              ElementsAre("count", "penalised-count", "surrogate", "penalised-surrogate"));
  EXPECT_NEAR(described["best_known"].get<double>(),
              -json_of("threshold --case C1")["first_loud"].get<double>(), 0.002);
  EXPECT_EQ(described["best_point"][0], -described["best_known"].get<double>());
  const Json moved = Json::parse(out_of("evaluate top-speed-C1 --describe --instance 2"));
  EXPECT_EQ(moved["best_known"], described["best_known"]);
  EXPECT_NE(moved["lower"], described["lower"]);
}

TEST(Evaluate, AsksAMachineOfYourOwnAtItsLevelAndWithSettings) {
  write("machine.toml", out_of("scene --case C4"));
  const std::string own = "count-scene --scene machine.toml";
  EXPECT_EQ(answer(own, "[9]"), answer("count-C4", "[9]"));
  EXPECT_NE(answer(own + " --set restitution=0.2", "[9]"), answer("count-C4", "[9]"));
}

TEST(Evaluate, SaysWhichLineWasBad) {
  const Dialogue dialogue = asked("hs-71", "[1, 1, 1, 1]\n\n \t\r\n[1]\n[2, 2, 2, 2]");
  ASSERT_EQ(dialogue.answers.size(), 3U);
  EXPECT_EQ(dialogue.answers[1]["error"], "line 4: x must have 4 numbers");
  EXPECT_EQ(dialogue.answers[2]["evaluations"], 2) << "the last line needs no end";
  EXPECT_THAT(error_of("x = 1\xff\x1b"), HasSubstr("is no JSON"));
}

TEST(Evaluate, SurvivesLongLines) {
  const std::string deep(500'000, '['), blank(5'000'000, ' ');
  EXPECT_THAT(error_of(deep), HasSubstr("is no JSON"));
  EXPECT_THAT(error_of("[" + deep + std::string(500'000, ']') + "]"), HasSubstr("line 1: x must"));
  EXPECT_EQ(error_of("[" + std::string(5'000'000, '1') + "]"), "line 1: is longer than 4 MiB");
  EXPECT_EQ(error_of(blank + "[1, 1, 1, 1]"), "line 1: is longer than 4 MiB");
  EXPECT_EQ(error_of(blank + "[1, 1, 1, 1]" + blank), "line 1: is longer than 4 MiB");
  answer("hs-71", blank + "\n[1, 1, 1, 1]");  // none to what is blank
}

TEST(Evaluate, ProjectsAPointThatIsFarAway) {
  EXPECT_EQ(answer("hs-71", "[1e300, 1e300, 1e300, -1e308]")["true_values"],
            answer("hs-71", "[5, 5, 5, 1]")["true_values"]);
}

/// What a script of bash leaves behind.
Outcome call_from_bash(const std::string& script) {
  write("script", script);
  return call_in_shell("bash script");
}

TEST(Evaluate, AnswersAtOnce) {
  const Outcome outcome = call_from_bash(R"(
coproc asked { ricochet evaluate hs-71; }
echo '[1, 1, 1, 1]' >&"${asked[1]}"
read -r -t 20 -u "${asked[0]}" answer
echo "$answer"
exec {asked[1]}>&-
wait)");
  EXPECT_THAT(outcome.out, HasSubstr("\"evaluations\":1")) << outcome.err;
}

TEST(Evaluate, EndsWhereNobodyListens) {
  if (const auto reason = missing({"/dev/full"}); !reason.empty()) GTEST_SKIP() << reason;
  write("point", "[1, 1, 1, 1]");
  const Outcome full = call("evaluate hs-71 <point >/dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, testing::StartsWith("ricochet: standard output: "));
  const Outcome closed = call_from_bash(R"(
trap '' PIPE
{ yes '[1, 1, 1, 1]' 2>/dev/null | ricochet evaluate hs-71; echo "${PIPESTATUS[1]}" >&2; } | head -n 1)");
  EXPECT_EQ(closed.err, "ricochet: standard output: Broken pipe\n1\n");
}

}  // namespace
}  // namespace ricochet::cli
