#include <regex>

#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

/// Problems and solvers: listed, run, compared.
namespace ricochet::cli {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string machine = RICOCHET_SOURCE "/examples/machine.toml";

TEST(List, HasCasesSolversAndProblemsWithTheirBestValues) {
  const Json cases = json_of("list cases");
  ASSERT_EQ(cases.size(), 12U);
  EXPECT_EQ(cases[0]["paper_threshold"], 9.0);
  EXPECT_TRUE(cases[10]["paper_threshold"].is_null());
  const Json solvers = json_of("list solvers");
  EXPECT_EQ(solvers.size(), 71U);
  for (const auto& solver : solvers) EXPECT_NE(solver["version"], "") << solver["solver"];
  const Json problems = json_of("list problems");
  ASSERT_EQ(problems.size(), 221U + 15 + 27 + 116 + 53 + 9);
  for (const auto& problem : problems) {
    EXPECT_TRUE(problem["best_known"].is_number()) << problem["problem"];
  }
  EXPECT_EQ(problems[0]["problem"], "count-C1");
  EXPECT_EQ(problems[0]["formulations"], (Json{"count", "surrogate"}));
  EXPECT_EQ(problems[12]["problem"], "top-speed-C1");
  EXPECT_EQ(problems[12]["constraints"], 1);
  EXPECT_EQ(problems[12]["formulations"],
            (Json{"count", "penalised-count", "surrogate", "penalised-surrogate"}));
}

TEST(List, HasTheProblemsOfAFamilyAMachineAndThoseThatASolverAccepts) {
  const Json family = json_of("list problems --family top-speed");
  ASSERT_EQ(family.size(), 12U);
  EXPECT_EQ(family[0]["problem"], "top-speed-C1");
  const Json accepted = json_of("list problems --solver-accepts scan");
  ASSERT_GT(accepted.size(), 12U);
  for (const auto& problem : accepted) EXPECT_EQ(problem["dimension"], 1);
  const Json own = json_of("list problems --scene {} --set restitution=0.3", machine);
  EXPECT_EQ(own.size(), 18U);
  EXPECT_EQ(own[0]["problem"], "count-scene");
  EXPECT_TRUE(own[0]["best_known"].is_null());
}

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

TEST(Solve, RunsOneSolverAndJudgesIt) {
  const Json result = json_of("solve BISECTION top-speed-c1 --budget 30");
  EXPECT_EQ(result["problem"], "top-speed-C1") << "names are taken in any case";
  EXPECT_EQ(result["solved"], true);
  EXPECT_EQ(result["formulation"], "count");
  EXPECT_NEAR(result["point"][0].get<double>(),
              json_of("threshold --case C1")["first_loud"].get<double>(), 0.01);
  EXPECT_LE(result["evaluations"], 30);
  EXPECT_EQ(result["returned_solved"], true);
  const std::string speed = std::to_string(result["point"][0].get<double>()).substr(0, 6);
  EXPECT_THAT(out_of("solve bisection top-speed-C1 --budget 30"), HasSubstr("Returned: " + speed));
}

TEST(Solve, SaysWhatIsMaximisedWithItsUnitAndWithoutASign) {
  for (const std::string problem : {"top-speed-C1", "hard-top-speed-01", "robust-worst-C4"}) {
    EXPECT_THAT(out_of("solve random-search {} --budget 30", problem),
                ContainsRegex("Best evaluated: [0-9.]+ rad/s, [0-9.e-]+ from the best "
                              "known, [0-9.]+ rad/s\\.\nReturned: [0-9.]+ rad/s\\.\n"));
  }
  EXPECT_LT(json_of("solve random-search top-speed-C1 --budget 30")["objective"], 0)
      << "as minimised";
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
  const std::string shown = out_of("solve bisection top-speed-C1 --budget 30 --instance 2");
  std::smatch said;
  ASSERT_TRUE(std::regex_search(
      shown, said, std::regex("Best evaluated: ([0-9.]+) rad/s[^]*point: ([0-9.]+)\\.\n")));
  EXPECT_EQ(said[1], said[2]);
}

TEST(Solve, DisturbsWhatIsShownAndNotWhatIsJudged) {
  const std::string command = "solve random-search classic-sphere-5 --budget 50";
  const Json plain = json_of(command), noisy = json_of(command + " --perturbation noisy");
  EXPECT_EQ(plain["perturbation"], "plain");
  EXPECT_EQ(noisy["perturbation"], "noisy");
  double squares = 0;
  for (const double x : noisy["point"].get<std::vector<double>>()) squares += x * x;
  EXPECT_NEAR(noisy["objective"], squares, 1e-9 * squares) << "the noise would be 1e-3";
  EXPECT_NE(json_of(command + " --perturbation reflected")["point"], plain["point"]);
}

report::Results results_of(const std::string& folder) {
  return report::results_in(report::data_in(read(folder + "/data.json")));
}

/// The first family on a page.
report::Results family_of(const std::string& page) {
  return results_of(page).parts.at("families").at(0).results;
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
  EXPECT_EQ(cobyla, (std::set<std::string>{"count", "surrogate", "penalised-count",
                                           "penalised-surrogate"}));
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
                     machine),
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
  const auto row_of = [&](const std::string& problem) {
    return endings.find(
        [&](const Row& one) { return one.text("problem") == "pathological-" + problem; });
  };
  for (const auto& [problem, ending] :
       {std::pair("throws", "threw"), {"hangs", "killed"}, {"crashes", "crashed"}}) {
    const auto row = row_of(problem);
    ASSERT_TRUE(row) << problem;
    EXPECT_EQ(row->number(ending), 2) << problem;
    EXPECT_EQ(row->number("runs"), 2) << problem;
  }
  EXPECT_EQ(row_of("no-number")->number("solved"), 1) << "BOBYQA";
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
          "name = \"versions\"\n[[solver]]\nname = \"mine\"\nof = \"nlopt-bobyqa\"\n"
          "options = { initial_step = " +
              step +
              " }\n[[part]]\nproblems = [\"classic-*-[2-6]\", \"classic-b*\"]\n"
              "solvers = [\"mine\", \"random-search\"]\nbudgets = [100]\ninstances = 3\n");
    out_of("run plan.toml --out " + step);
  }
  const std::string words = out_of("compare --stores 0.25 0.001/runs.sqlite");
  EXPECT_THAT(words, ContainsRegex("\nmine +original +.* yes +NLopt "));
  EXPECT_THAT(words, testing::EndsWith("\n1 of 2 entries: the same\n"));
  const Json data = json_of("compare --stores 0.25 0.001");
  EXPECT_EQ(data["families"].size(), 1U);
  ASSERT_EQ(data["entries"].size(), 2U);
  const Json &mine = data["entries"][0], &other = data["entries"][1];
  EXPECT_EQ(mine["solver"], "mine");
  EXPECT_EQ(mine["sure"], true);
  EXPECT_GT(mine["ratio"], 1.0);
  EXPECT_GT(mine["dearer"], mine["cheaper"]);
  EXPECT_EQ(other["p"], 1.0);
  EXPECT_EQ(other["ratio"], 1.0);
}

}  // namespace
}  // namespace ricochet::cli
