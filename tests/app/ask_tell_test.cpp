#include "tests/app/tool.h"

/// Problems whose values are told, beside the same ones that a program computes.
namespace ricochet::cli {
namespace {

constexpr const char* variables = R"(
[[variable]]
name = "width"
unit = "mm"
lower = -2
upper = 2
start = 1.5
[[variable]]
name = "rate"
lower = 0.01
upper = 100
start = 10
scale = "logarithmic"
[[constraint]]
name = "slack"
)";

/// The objective and the constraint of both.
std::vector<double> values_at(double width, double rate) {
  return {(width - 0.5) * (width - 0.5) + std::log(rate) * std::log(rate), 0.25 - width};
}

void write_problems() {
  write("told/problem.toml", std::string("name = 'bowl'\n[program]\ntold = true\n") + variables);
  write("asked.toml",
        std::string("name = 'bowl'\n[program]\ncommand = 'python3 asked.py'\n") + variables);
  write("asked.py", R"(import json, math, sys
for line in sys.stdin:
    width, rate = json.loads(line)['x']
    print(json.dumps({'objective': (width - 0.5) * (width - 0.5) + math.log(rate) * math.log(rate),
                      'constraints': [0.25 - width]}), flush=True)
)");
}

TEST(AskAndTell, ComeToWhatASolverFindsThatDoesNotWait) {
  write_problems();
  for (const std::string solver : {"nlopt-cobyla", "mads-tuned", "auto", "random-search"}) {
    const Json whole = json_of("solve {} asked.toml --allow-programs --budget 25 --seed 3", solver);
    Json asked;
    for (int told = 0;; ++told) {
      asked = json_of("ask told --solver {} --budget 25 --seed 3", solver);
      if (asked["id"].is_null()) break;
      ASSERT_LT(told, 30) << "more than it can pay";
      const Json& point = asked["point"];
      const auto values = values_at(point["width"].get<double>(), point["rate"].get<double>());
      out_of("tell told {} {}", asked["id"].get<int>(),
             fmt::format("{:.17g}", fmt::join(values, " ")));
    }
    EXPECT_EQ(asked["evaluations"], 25);
    EXPECT_EQ(asked["best"]["objective"], whole["objective"]) << solver;
    EXPECT_EQ(asked["best"]["variables"], whole["best"]["variables"]) << solver;
    EXPECT_EQ(asked["evaluations_from_store"], whole["evaluations_by_program"].get<int>() +
                                                   whole["evaluations_from_store"].get<int>());
  }
}

TEST(AskAndTell, KeepWhatIsToldInLinesUpToTheFirstThatIsWrong) {
  write_problems();
  EXPECT_EQ(json_of("ask told --solver nlopt-cobyla")["id"], 1);
  EXPECT_EQ(json_of("ask told --solver nlopt-cobyla")["id"], 1) << "it is the same point";
  write("first.jsonl", R"({"id": 1, "objective": 2, "constraints": [-1]})");
  out_of("tell told < first.jsonl");
  EXPECT_EQ(json_of("ask told --solver nlopt-cobyla")["id"], 2);
  EXPECT_EQ(json_of("ask told --solver mads-tuned")["id"], 3) << "of another solver";
  write("more.jsonl", R"({"id": 3, "error": "it broke"}

{"id": 2, "objective": 1}
)");
  expect_refusal("tell told < more.jsonl",
                 "line 3: point 2: constraints is missing: {\"objective\":1}; 1 earlier line is");
  const Json after = json_of("ask told --solver mads-tuned");
  EXPECT_EQ(after["failed_evaluations"], 1);
  EXPECT_EQ(after["failures"][0]["reason"], "said: it broke");
}

TEST(AskAndTell, TakeBackWhatWasMistyped) {
  write_problems();
  out_of("ask told --solver random-search");
  out_of("tell told 1 20 -1");
  expect_refusal("tell told 1 2 -1", "point 1: is told already");
  out_of("tell told 1 2 -1 --replace");
  const Json done = json_of("ask told --solver random-search --budget 1");
  EXPECT_TRUE(done["id"].is_null());
  EXPECT_EQ(done["best"]["objective"], 2);
}

TEST(AskAndTell, RefuseWhatCannotBeMeant) {
  write_problems();
  write("empty/readme", "");
  out_of("ask told --solver nlopt-cobyla");
  expect_refusal("ask asked.toml", "a program computes its values");
  expect_refusal("ask empty", "problem.toml");
  expect_refusal("ask told --solver nlopt-cobila", "nlopt-cobyla");
  expect_refusal("ask told --budget 0", "--budget 0: must be within 1..1000000000");
  expect_refusal("tell told 2 1 1", "point 2: was not asked for; these are: 1");
  expect_refusal("tell told 1", "either its values, objective slack, or --failed");
  expect_refusal("tell told 1 5 1 --failed late", "either its values");
  expect_refusal("tell told 1 5", "gave 1 numbers, not 2: objective, slack");
  expect_refusal("tell told 1 5 low", "gave \"low\", which is no number");
  expect_refusal("problem check told/problem.toml", "its values are told");
  const Outcome solved = call("solve nlopt-cobyla told/problem.toml");
  EXPECT_EQ(solved.exit_code, 1);
  EXPECT_THAT(solved.err, testing::HasSubstr("not told yet"));
}

}  // namespace
}  // namespace ricochet::cli
