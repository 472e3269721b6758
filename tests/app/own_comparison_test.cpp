#include <set>

#include "src/report/text.h"
#include "tests/app/tool.h"

/// Solvers compared on problem files, by a program that keeps a list of what it was asked.
namespace ricochet::cli {
namespace {

/// A problem file bowl.toml in a folder of here(), whose program writes a line for each point that
/// it computes, and its value, into bowl.log beside it: a bowl with its bottom, 1, at (0.3, -0.6).
void bowl(const std::string& folder = ".", double milliseconds = 0, bool noise = false) {
  write(folder + "/bowl.py", fmt::format(R"(import json, random, sys, time
for line in sys.stdin:
    x, y = json.loads(line)['x']
    time.sleep({})
    z = 1 + (x - 0.3)**2 + 10 * (y + 0.6)**2 + {} * random.gauss(0, 0.1)
    with open('bowl.log', 'a') as log: log.write(f'{{x!r}} {{y!r}} {{z!r}}\n')
    print(json.dumps({{'objective': z}}), flush=True)
)",
                                         1e-3 * milliseconds, noise ? 1 : 0));
  write(folder + "/bowl.toml", fmt::format(R"(name = "bowl"
noise = {}
tolerance = 0.05
[program]
command = "python3 bowl.py"
[[variable]]
name = "x"
lower = -1
upper = 1
start = 0.75
[[variable]]
name = "y"
lower = -1
upper = 1
)",
                                           noise));
}

constexpr const char* few =
    " --allow-programs --solvers nlopt-cobyla,nlopt-cobyla-tuned,random-search";

/// What the program was asked, in order.
struct Asked {
  std::vector<std::string> points;
  std::vector<double> values;

  std::set<std::string> distinct() const { return {points.begin(), points.end()}; }
};

Asked asked_in(const std::string& log) {
  Asked asked;
  for (const std::string& line : lines_of(read(log))) {
    const std::size_t end = line.rfind(' ');
    asked.points.push_back(line.substr(0, end));
    asked.values.push_back(std::stod(line.substr(end)));
  }
  return asked;
}

TEST(OwnComparison, KnowsTheBestOfAllAndComputesAPointOnce) {
  bowl();
  const Json told =
      json_of("compare --problems bowl.toml --starts 2 --budget 20 --out page{}", few);
  const Asked asked = asked_in("bowl.log");
  EXPECT_EQ(told["best"]["objective"], *std::ranges::min_element(asked.values));
  EXPECT_EQ(asked.points.front(), "0.75 0.0") << "the file's start comes first";
  EXPECT_EQ(asked.points.size(), asked.distinct().size());
  EXPECT_EQ(told["evaluations_by_program"], asked.points.size());
  ASSERT_EQ(told["runs"].size(), 6);
  std::int64_t charged = 0;
  for (const Json& run : told["runs"]) {
    charged += run["charged"].get<std::int64_t>();
    const Json again =
        json_of("solve {} bowl.toml --allow-programs --formulation original --seed {} --budget 40",
                run["solver"].get<std::string>(), run["start"].get<int>());
    EXPECT_EQ(again["objective"], run["objective"]) << run;
    EXPECT_EQ(again["evaluations_by_program"], 0) << run;
  }
  EXPECT_GT(charged, told["evaluations_by_program"]) << "both are charged";
  EXPECT_EQ(told["evaluations_by_program"].get<std::int64_t>() +
                told["evaluations_from_store"].get<std::int64_t>(),
            charged);
  const report::Results page = results_of("page");
  EXPECT_EQ(page.table("entries")->rows.size(), 3);
  ASSERT_TRUE(page.chart("best-so-far") && page.chart("targets-reached"));
  EXPECT_EQ(page.chart("best-so-far")->series.size(), 3);
  for (const report::Series& curve : page.chart("best-so-far")->series) {
    const double end = curve.samples.back().value.value();
    std::vector<double> reached;
    for (const Json& run : told["runs"]) {
      if (run["solver"] == curve.label) reached.push_back(run["objective"].get<double>());
    }
    ASSERT_EQ(reached.size(), 2);
    EXPECT_NEAR(end, (reached[0] + reached[1]) / 2, 1e-5 * end) << "the median over the starts";
  }
  EXPECT_THAT(read("page/summary.md"), HasSubstr("The reference is not the"));
}

TEST(OwnComparison, LosesOnlyWhatWasInFlight) {
  const std::string command =
      std::string(" --starts 2 --budget 60 --workers 2 --out page --format json") + few;
  bowl("whole");
  bowl("cut", 2);
  const Json whole = Json::parse(out_of("compare --problems whole/bowl.toml" + command));
  const Outcome killed = call_in_shell(
      "ricochet compare --problems cut/bowl.toml" + command +
      " & while kill -0 $! && [ $(cat cut/bowl.log | wc -l) -lt 100 ]; do sleep 0.02; done;"
      " kill -KILL $!; wait $!");
  EXPECT_EQ(killed.exit_code, 137) << killed.err;
  const std::size_t before = asked_in("cut/bowl.log").points.size();
  const Json cut = Json::parse(out_of("compare --problems cut/bowl.toml" + command));
  const Asked asked = asked_in("cut/bowl.log");
  EXPECT_GE(before, 100);
  EXPECT_GT(asked.points.size(), before) << "it was not killed in time";
  EXPECT_LE(asked.points.size(), asked.distinct().size() + 2) << "of two workers";
  EXPECT_EQ(asked.distinct(), asked_in("whole/bowl.log").distinct());
  EXPECT_EQ(cut["digest"], whole["digest"]);
}

TEST(OwnComparison, SharesEvaluationsOutEvenly) {
  bowl();
  write("other/bowl.py", read("bowl.py"));
  write("other/bowl.toml",
        "name = 'other'" + read("bowl.toml").substr(read("bowl.toml").find('\n')));
  const auto shares = [](const Json& told) {
    std::set<std::pair<std::string, int>> runs;
    for (const Json& run : told["runs"]) {
      EXPECT_EQ(run["budget"], told["budget"]);
      EXPECT_LE(run["charged"], told["budget"]);
      runs.emplace(run["solver"].get<std::string>(), run["start"].get<int>());
    }
    return std::pair(runs.size(), told["budget"].get<int>());
  };
  const std::string all = std::string("compare --out page --problems bowl.toml") + few;
  EXPECT_EQ(shares(json_of(all + " --evaluations 100")), std::pair(3UL, 33));
  EXPECT_EQ(shares(json_of(all + " --evaluations 1300")), std::pair(6UL, 216));
  EXPECT_EQ(shares(json_of(all + " --evaluations 1300 --starts 1")), std::pair(3UL, 433));
  const Json both =
      json_of("compare --out page --problems bowl.toml,other/bowl.toml{} --evaluations 200", few);
  for (const Json& told : both) EXPECT_EQ(shares(told), std::pair(3UL, 33));
  EXPECT_EQ(both[1]["problem"], "other");
  EXPECT_TRUE(exists("page/other/index.html"));
}

TEST(OwnComparison, MakesEvaluationsOfTime) {
  bowl(".", 20);
  const Json told =
      json_of("compare --out page --problems bowl.toml{} --seconds 0.6 --workers 1", few);
  EXPECT_GE(told["budget"], 1);
  EXPECT_LE(told["budget"], 0.6 / 0.02 / 3);
  ASSERT_EQ(told["runs"].size(), 3);
}

TEST(OwnComparison, OfNoisyValuesGoesOnWithTheSame) {
  bowl(".", 0, true);
  const std::string command =
      std::string("compare --problems bowl.toml --budget 20 --out page") + few;
  const Json first = json_of(command);
  EXPECT_NEAR(first["best"]["mean"].get<double>(), 1, 0.3);
  EXPECT_EQ(first["evaluations_from_store"], 0) << "each run has evaluations of its own";
  const std::size_t asked = asked_in("bowl.log").points.size();
  const Json second = json_of(command);
  EXPECT_EQ(second["evaluations_by_program"], 0);
  EXPECT_EQ(second["digest"], first["digest"]);
  EXPECT_EQ(second["best"], first["best"]);
  EXPECT_EQ(asked_in("bowl.log").points.size(), asked);
}

TEST(OwnComparison, RefusesWhatItCannotDo) {
  bowl();
  expect_refusal("compare --problems bowl.toml", "python3 bowl.py; add --allow-programs");
  const std::string bowl_alone = "compare --problems bowl.toml --allow-programs ";
  for (const auto& [options, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"--starts 0", "--starts 0: must be within 1..100"},
           {"--workers -1", "--workers -1: must be within 0..1000"},
           {"--evaluations 0", "--evaluations 0: must be within 1.."},
           {"--seconds 0", "--seconds 0: must be > 0"},
           {"--budget 1,2", "--budget: must be one number"},
           {"--budget 5 --seconds 1", "excludes"},
           {"--quick", "--quick: is not for problem files"},
           {"--instances 3", "--instances: is not for problem files"}}) {
    expect_refusal(bowl_alone + options, complaint);
  }
  expect_refusal("compare --problems bowl.toml,hs-71 --allow-programs", "some are problem files");
  expect_refusal("compare --problems bowl.toml,bowl.toml --allow-programs", "has the same name");
  expect_refusal("compare --problems hs-71 --seconds 1", "--seconds: needs problem files");
  expect_refusal("compare --problems hs-71 --format json", "--format: needs --stores, or problem");
  for (const auto& [options, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"--evaluations 2 --solvers 'nlopt-c*'", "--evaluations 2: must be at least 3, one for"},
           {"--formulations penalised-count", "--formulations penalised-count: nothing fits"},
           {"--solvers cobilla", "--solvers cobilla: nothing fits"},
           {"--solvers ipopt", "bowl: none of these solvers accepts it"}}) {
    const Outcome refused = call(bowl_alone + options);  // which has said what it would start
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("\nricochet: " + complaint));
  }
  EXPECT_FALSE(exists("bowl.log")) << "nothing was computed";
}

TEST(OwnComparison, HasASolverThatChoosesOnlyByName) {
  bowl();
  const auto solvers = [](const std::string& patterns) {
    std::set<std::string> names;
    const Json told = json_of(
        "compare --problems bowl.toml --allow-programs --starts 1 --budget 3 --out page "
        "--solvers " +
        patterns);
    for (const Json& entry : told["entries"]) names.insert(entry["solver"].get<std::string>());
    return names;
  };
  EXPECT_EQ(solvers("'aut*,random-search'"), std::set<std::string>{"random-search"});
  EXPECT_EQ(solvers("auto,random-search"), (std::set<std::string>{"auto", "random-search"}));
}

TEST(OwnComparison, FailsWhereNothingHasAValue) {
  bowl();
  write("bowl.py", "raise SystemExit('no licence')\n");
  const Outcome outcome =
      call("compare --problems bowl.toml --starts 1 --budget 2 --out page{}", few);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("bowl: no evaluation had a value"));
  EXPECT_THAT(outcome.out, HasSubstr("no licence"));
}

}  // namespace
}  // namespace ricochet::cli
