#include "src/report/text.h"
#include "tests/app/tool.h"

/// Problems and solvers: listed, evaluated, run, compared.
namespace ricochet::cli {
namespace {

using testing::ContainsRegex;

/// The lines of a list on a terminal of that many columns.
std::vector<std::string> lines_on_terminal(const std::string& what, int columns) {
  const Outcome shown = call_in_shell(fmt::format(
      "script -qec 'stty cols {} && ricochet list {}' /dev/null </dev/null", columns, what));
  EXPECT_EQ(shown.exit_code, 0);
  std::vector<std::string> lines = lines_of(shown.out);
  for (std::string& line : lines) line = line.substr(0, line.find('\r'));
  return lines;
}

TEST(List, IsAsWideAsTheTerminalAndNeverCutElsewhere) {
  if (const auto reason = no_terminal(); !reason.empty()) GTEST_SKIP() << reason;
  for (const std::string what : {"cases", "problems", "solvers", "interpretations"}) {
    const auto whole = lines_on_terminal(what, 1000);
    EXPECT_EQ(whole, lines_of(out_of("list " + what)));
    const auto cut = lines_on_terminal(what, 60);
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
      EXPECT_EQ(cut[i], whole[i].size() <= 60 ? whole[i] : whole[i].substr(0, 57) + "...");
    }
  }
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
  EXPECT_THAT(full.err, StartsWith("ricochet: standard output: "));
  const Outcome closed = call_from_bash(R"(
trap '' PIPE
{ yes '[1, 1, 1, 1]' 2>/dev/null | ricochet evaluate hs-71; echo "${PIPESTATUS[1]}" >&2; } | head -n 1)");
  EXPECT_EQ(closed.err, "ricochet: standard output: Broken pipe\n1\n");
}

/// The value beside a point is that of the problem as it is stated at that point, also where the
/// solver had another box or other coordinates.
TEST(Solve, SaysTheBestPointAsTheProblemHasIt) {
  for (const std::string problem : {"count-C2", "top-speed-C1", "profile-wear-8-C1",
                                    "design-count-C1", "classic-rosenbrock-5", "hs-26"}) {
    for (const std::string how :
         {"--instance 0", "--instance 2", "--instance 3 --perturbation reflected"}) {
      const std::string command = filled("solve random-search {} --budget 30 {}", problem, how);
      const Json told = json_of(command);
      write("point", told["stated_point"].dump());
      const Json stated = Json::parse(out_of("evaluate {} <point", problem));
      const double objective = stated["true_values"]["objective"];
      EXPECT_NEAR(told["objective"].get<double>(), objective, 1e-9 * (1 + std::abs(objective)))
          << command;
      EXPECT_EQ(told["point"] == told["stated_point"], how == "--instance 0") << command;
    }
  }
}

/// The first family on a page.
report::Results family_of(const std::string& page) {
  return results_of(page).parts.at("families").at(0).results;
}

/// A problem file in here(), by its command; a valley whose bottom is at x = 20, y = 3, of 7 kg.
std::string own_problem(const std::string& command) {
  write("valley.py",
        "import json, math, sys\n"
        "for line in sys.stdin:\n"
        "    x, y = json.loads(line)['x']\n"
        "    if y < -4: sys.exit('too low')\n"
        "    z = (math.log(x / 20))**2 + (y - 3)**2\n"
        "    print(json.dumps({'objective': 7 - z, 'constraints': [3 - y]}), flush=True)\n");
  return write("valley.toml",
               "name = 'valley'\nunit = 'kg'\ngoal = 'maximise'\n[program]\ncommand = '" + command +
                   "'\n[[variable]]\nname = 'width'\nunit = 'mm'\nlower = 1\nupper = 1000\n"
                   "scale = 'logarithmic'\n[[variable]]\nname = 'height'\nlower = -5\nupper = 5\n"
                   "[[constraint]]\nname = 'least'\n");
}

TEST(OwnProblem, IsSolvedInItsOwnWords) {
  own_problem("python3 valley.py");
  const std::string allowed = " --allow-programs --budget 400";
  expect_refusal("solve nlopt-cobyla valley.toml", "python3 valley.py; add --allow-programs");
  expect_refusal("solve nlopt-cobyla valley.toml --scene machine.toml", "is a problem file");
  EXPECT_FALSE(exists("valley.evaluations")) << "nothing is written";
  const Json told = json_of("solve nlopt-cobyla valley.toml" + allowed);
  EXPECT_NEAR(told["objective"].get<double>(), -7, 1e-6) << "is minimised";
  const Json& best = told["best"];
  EXPECT_NEAR(best["objective"].get<double>(), 7, 1e-6);
  EXPECT_EQ(best["variables"][0]["name"], "width");
  EXPECT_NEAR(best["variables"][0]["value"].get<double>(), 20, 1e-2);
  EXPECT_NEAR(told["stated_point"][0].get<double>(), 20, 1e-2);
  EXPECT_TRUE(best["constraints"][0]["active"].get<bool>());
  EXPECT_GT(told["evaluations_by_program"], 100);
  const std::string said = out_of("solve nlopt-cobyla valley.toml" + allowed);
  EXPECT_THAT(said, AllOf(HasSubstr("Best evaluated: 7 kg"), HasSubstr(" mm\n  height = 3\n"),
                          HasSubstr("least: "), HasSubstr("holds, and is active"),
                          HasSubstr("\n0 evaluations by python3 valley.py, ")));
  const std::string random = out_of("solve random-search valley.toml" + allowed);
  EXPECT_THAT(random, AllOf(HasSubstr(" failed. Failures so far:\n"),
                            HasSubstr("its last words: too low")));
  EXPECT_THAT(call("solve random-search valley.toml --budget 5 --allow-programs").out,
              HasSubstr("0 evaluations by"));
}

TEST(OwnProblem, IsCheckedAndEvaluated) {
  own_problem("python3 valley.py");
  const Json told = json_of("problem check valley.toml --allow-programs");
  EXPECT_NEAR(told["objectives"][2].get<double>(),
              7 - std::pow(std::log(std::sqrt(1000) / 20), 2) - 9, 1e-9);
  EXPECT_EQ(told["noisy"], false);
  EXPECT_THAT(told["solvers"].dump(), AllOf(HasSubstr("nlopt-cobyla"), Not(HasSubstr("ipopt"))));
  const Outcome answered =
      call_in_shell("echo '[2, 1]' | ricochet evaluate valley.toml --allow-programs");
  EXPECT_NEAR(Json::parse(answered.out)["objective"].get<double>(),
              -(7 - std::pow(2 - std::log(20), 2) - 4), 1e-9)
      << "as a solver sees it: the logarithm of the width";
  own_problem("python3 none.py");
  const Outcome failed = call("problem check valley.toml --allow-programs");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_THAT(failed.out,
              HasSubstr("At the start it has no values: ended with exit code 2; its last words: "));
  EXPECT_EQ(call("solve random-search valley.toml --allow-programs --budget 3").exit_code, 1);
}

TEST(Compare, WritesAReportOfEverySolverInEveryFormulation) {
  EXPECT_THAT(
      out_of("compare --problems top-speed-C1,profile-count-2-C4 --budget 5,20 --instances 2 "
             "--solvers 'nlopt-co*,random*,bisection' --out mine"),
      ContainsRegex("\ntop-speed +20 "));
  EXPECT_TRUE(exists("mine/index.html"));
  EXPECT_TRUE(exists("mine/leaders.csv"));
  EXPECT_EQ(report::data_in(read("mine/data.json"))["pages"],
            (Json{"top-speed", "profile-count", "solvers", "view"}));
  const report::Results family = family_of("mine/top-speed");
  std::set<std::string> cobyla;
  each_row(*family.table("results"), [&](const Row& result) {
    if (result.text("solver") == "nlopt-cobyla") cobyla.insert(result.text("formulation"));
    EXPECT_EQ(result.number("runs"), 2);
    EXPECT_LE(result.number("returned_lower"), result.number("returned"));
  });
  EXPECT_THAT(cobyla, ElementsAre("count", "penalised-count", "penalised-surrogate", "surrogate"));
  EXPECT_EQ(family.table("surrogate-bias")->rows.size(), 1U);
  EXPECT_FALSE(family.table("formulations")->rows.empty());
  const report::Results all = results_of("mine");
  EXPECT_FALSE(all.table("relocated-optima")->rows.empty());
  EXPECT_EQ(*all.value("relocated"), Value("1 problem of 1 variable, 1 problem of 2 variables"));
}

TEST(Compare, AnnouncesAndStoresAllOfItsRunsAndReadsThemAlone) {
  const std::string command =
      "compare --problems top-speed-C[14] --solvers 'random*,bisection,scan,nlopt-co*' "
      "--budget 5,20 --instances 2 --out mine";
  const Outcome first = call(command);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  Json data = report::data_in(read("mine/data.json"));
  const std::string runs = fmt::format("{} runs", data["values"]["runs"].get<int>());
  EXPECT_THAT(first.err, HasSubstr(runs + " of "));
  std::set<std::string> changes;
  const report::Results results = results_of("mine");
  each_row(*results.table("orders"), [&](const Row& row) { changes.insert(row.text("changed")); });
  EXPECT_THAT(changes, testing::IsSupersetOf({"machines drawn around the cases", "other seeds"}));
  EXPECT_FALSE(results.table("relocated-optima")->rows.empty());
  EXPECT_THAT(call(command).err, HasSubstr(runs + " are there already"));
  Json same = report::data_in(read("mine/data.json"));
  same["made"] = data["made"];
  EXPECT_EQ(same, data);
}

TEST(Compare, AsksTheProblemsOfAMachineOfOnesOwn) {
  EXPECT_THAT(out_of("compare --scene {} --problems top-speed-scene --budget 20 --instances 2 "
                     "--solvers 'random*,bisection' --set restitution=0.3 --out mine",
                     RICOCHET_SOURCE "/examples/machine.toml"),
              ContainsRegex("\ntop-speed +20 "));
  EXPECT_EQ(report::data_in(read("mine/data.json"))["pages"],
            (Json{"top-speed", "solvers", "view"}));
  EXPECT_THAT(out_of("replay mine 1"), HasSubstr("The same, to the last bit."));
}

TEST(Compare, SurvivesProblemsThatThrowHangAndCrash) {
  out_of(
      "compare --family pathological --solvers 'random-search,nlopt-bobyqa' --quick "
      "--instances 1 --budget 100 --out mine");
  const report::Results page = results_of("mine/robustness");
  const Table& endings = *page.table("pathological");
  EXPECT_EQ(endings.rows.size(), 9U);
  for (const auto& [problem, ending, runs] : {std::tuple("throws", "threw", 2),
                                              {"hangs", "killed", 2},
                                              {"crashes", "crashed", 2},
                                              {"no-number", "solved", 1}}) {  // by BOBYQA
    const std::string name = filled("pathological-{}", problem);
    const auto row = endings.find([&](const Row& one) { return one.text("problem") == name; });
    ASSERT_TRUE(row) << name;
    EXPECT_EQ(row->number(ending), runs) << name;
    EXPECT_EQ(row->number("runs"), 2) << name;
  }
  EXPECT_THAT(read("mine/robustness/summary.md"), HasSubstr("2 killed"));
}

TEST(Compare, ChoosesFormulations) {
  out_of(
      "compare --problems top-speed-C1 --solvers nlopt-cobyla --formulations '*count' "
      "--budget 5 --instances 1 --out mine");
  EXPECT_EQ(family_of("mine/top-speed").table("results")->rows.size(), 2U);
}

/// BOBYQA with a first step of a quarter of the box and of a thousandth, random search beside it.
TEST(Compare, SaysWhichEntriesChangedBetweenStores) {
  for (const std::string step : {"0.25", "0.001"}) {
    write("plan.toml",
          "[[solver]]\nname = \"mine\"\nof = \"nlopt-bobyqa\"\noptions = { initial_step = " + step +
              " }\n[[part]]\nproblems = [\"classic-*-[2-6]\", \"classic-b*\"]\n"
              "solvers = [\"mine\", \"random-search\"]\nbudgets = [100]\ninstances = 3\n");
    out_of("run plan.toml --out " + step);
  }
  const std::string words = out_of("compare --stores 0.25 0.001/runs.sqlite");
  EXPECT_THAT(words, ContainsRegex("\nmine +original +.* yes +NLopt "));
  EXPECT_THAT(words, EndsWith("\n1 of 2 entries: the same\n"));
  const Json data = json_of("compare --stores 0.25 0.001");
  EXPECT_EQ(data["families"].size(), 1U);
  ASSERT_EQ(data["entries"].size(), 2U);
  const Json &mine = data["entries"][0], &other = data["entries"][1];
  EXPECT_EQ((Json{mine["solver"], mine["sure"]}), (Json{"mine", true}));
  EXPECT_GT(mine["ratio"], 1.0);
  EXPECT_GT(mine["dearer"], mine["cheaper"]);
  EXPECT_EQ((Json{other["p"], other["ratio"]}), (Json{1.0, 1.0}));
}

}  // namespace
}  // namespace ricochet::cli
