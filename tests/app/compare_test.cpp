#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using report::Json;

/// What the page of a family says of the first one on it.
report::Results family_of(const std::filesystem::path& folder) {
  return report::results_in(report::data_in(read(folder / "data.json")))
      .parts.at("families")
      .at(0)
      .results;
}

TEST(Compare, WritesAReportOfEverySolverInEveryFormulation) {
  const auto folder = fresh_folder() / "mine";
  const Outcome outcome = call(
      "compare --problems top-speed-C1,profile-count-2-C4 --solvers 'nlopt-co*,random*,bisection' "
      "--budget 5,20 --instances 2 --out " +
      folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\ntop-speed +20 "));
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "leaders.csv"));
  const Json data = report::data_in(read(folder / "data.json"));
  EXPECT_EQ(data["pages"], (Json{"top-speed", "profile-count", "solvers", "view"}));
  const report::Results family = family_of(folder / "top-speed");
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
  const report::Results all = report::results_in(data);
  EXPECT_FALSE(all.table("relocated-optima")->rows.empty());
  EXPECT_EQ(*all.value("relocated"), Value("1 problem of 1 variable, 1 problem of 2 variables"));
}

TEST(Compare, AnnouncesAndStoresAllOfItsRunsAndReadsThemAlone) {
  const auto folder = fresh_folder() / "mine";
  const std::string command =
      "compare --problems top-speed-C[14] --solvers 'random*,bisection,scan,nlopt-co*' "
      "--budget 5,20 --instances 2 --out " +
      folder.string();
  const Outcome first = call(command);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const Json data = report::data_in(read(folder / "data.json"));
  const report::Results results = report::results_in(data);
  const std::string runs = fmt::format("{} runs", data["values"]["runs"].get<int>());
  EXPECT_THAT(first.err, testing::HasSubstr(runs + " of "));
  std::set<std::string> whats;
  each_row(*results.table("orders"), [&](const Row& row) { whats.insert(row.text("changed")); });
  EXPECT_TRUE(whats.contains("machines drawn around the cases"));
  EXPECT_TRUE(whats.contains("other seeds"));
  EXPECT_FALSE(results.table("relocated-optima")->rows.empty());
  const Outcome again = call(command);
  EXPECT_THAT(again.err, testing::HasSubstr(runs + " are there already"));
  Json same = report::data_in(read(folder / "data.json"));
  same["made"] = data["made"];
  EXPECT_EQ(same, data);
}

TEST(Compare, AsksTheProblemsOfAMachineOfOnesOwn) {
  const auto folder = fresh_folder() / "mine";
  const std::string command =
      "compare --scene " RICOCHET_SOURCE
      "/examples/machine.toml --problems top-speed-scene --solvers 'random*,bisection' "
      "--budget 20 --instances 2 --set restitution=0.3 --out " +
      folder.string();
  const Outcome outcome = call(command);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\ntop-speed +20 "));
  EXPECT_EQ(report::data_in(read(folder / "data.json"))["pages"],
            (Json{"top-speed", "solvers", "view"}));
  EXPECT_THAT(call("replay " + (folder / "runs.sqlite").string() + " 1").out,
              testing::HasSubstr("The same, to the last bit."));
  expect_refusal("compare --set mass=2 --out " + folder.string(),
                 "--set mass=2: changes a machine file");
}

TEST(Compare, SurvivesProblemsThatThrowHangAndCrash) {
  const auto folder = fresh_folder() / "mine";
  const Outcome outcome = call(
      "compare --family pathological --solvers 'random-search,nlopt-bobyqa' --quick "
      "--instances 1 --budget 100 --out " +
      folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const report::Results page =
      report::results_in(report::data_in(read(folder / "robustness" / "data.json")));
  const Table& endings = *page.table("pathological");
  EXPECT_EQ(endings.rows.size(), 9U);
  for (const auto& [problem, ending] :
       {std::pair("throws", "threw"), {"hangs", "killed"}, {"crashes", "crashed"}}) {
    const auto row = endings.find([&, name = "pathological-" + std::string(problem)](
                                      const Row& one) { return one.text("problem") == name; });
    ASSERT_TRUE(row) << problem;
    EXPECT_EQ(row->number(ending), 2) << problem;
    EXPECT_EQ(row->number("runs"), 2) << problem;
  }
  const auto bowl =
      endings.find([](const Row& one) { return one.text("problem") == "pathological-no-number"; });
  EXPECT_EQ(bowl->number("solved"), 1) << "BOBYQA";
  EXPECT_THAT(read(folder / "robustness" / "summary.md"), testing::HasSubstr("2 killed"));
  expect_refusal("compare --family pathologic",
                 "there is no such family; did you mean pathological?");
}

TEST(Compare, ChoosesFormulations) {
  const auto folder = fresh_folder() / "mine";
  const Outcome outcome = call(
      "compare --problems top-speed-C1 --solvers nlopt-cobyla --formulations '*count' --budget 5 "
      "--instances 1 --out " +
      folder.string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(family_of(folder / "top-speed").table("results")->rows.size(), 2U);
}

/// BOBYQA with a first step of a quarter of the box and of a thousandth, random search beside it.
TEST(Compare, SaysWhichEntriesChangedBetweenStores) {
  const auto folder = fresh_folder();
  const auto run = [&](const std::string& step) {
    const auto plan =
        write(folder, step + ".toml",
              "name = \"versions\"\n[[solver]]\nname = \"mine\"\nof = \"nlopt-bobyqa\"\n"
              "options = { initial_step = " +
                  step +
                  " }\n"
                  "[[part]]\nproblems = [\"classic-*-[2-6]\", \"classic-b*\"]\n"
                  "solvers = [\"mine\", \"random-search\"]\nbudgets = [100]\ninstances = 3\n");
    EXPECT_EQ(
        call(fmt::format("run {} --out {}", plan.string(), (folder / step).string())).exit_code, 0);
    return (folder / step / "runs.sqlite").string();
  };
  const std::string stores = "compare --stores " + run("0.25") + " " + run("0.001");
  const Outcome words = call(stores);
  EXPECT_THAT(words.out, testing::ContainsRegex("\nmine +original +.* yes +NLopt "));
  EXPECT_THAT(words.out, testing::EndsWith("\n1 of 2 entries: the same\n"));
  const Json data = Json::parse(call(stores + " --format json").out);
  EXPECT_EQ(data["families"].size(), 1U);
  ASSERT_EQ(data["entries"].size(), 2U);
  const Json& mine = data["entries"][0];
  EXPECT_EQ(mine["solver"], "mine");
  EXPECT_EQ(mine["sure"], true);
  EXPECT_GT(mine["ratio"], 1.0);
  EXPECT_GT(mine["dearer"], mine["cheaper"]);
  const Json& other = data["entries"][1];
  EXPECT_EQ(other["p"], 1.0);
  EXPECT_EQ(other["ratio"], 1.0);
}

TEST(Compare, RefusesWhatNothingFits) {
  expect_refusal("compare --problems top-sped-C1", "--problems top-sped-C1: nothing fits");
  expect_refusal("compare --solvers coblya", "--solvers coblya: nothing fits");
  expect_refusal("compare --problems xylophone", "nothing fits; see `ricochet list problems`");
  expect_refusal("compare --solvers xylophone", "nothing fits; see `ricochet list solvers`");
  expect_refusal("compare --solver xylophone", "no such solver; see `ricochet list solvers`");
  expect_refusal("compare --budget 20,10", "--budget 10");
  expect_refusal("compare --budget 0", "--budget 0");
  expect_refusal("compare --instances 0", "--instances 0");
  expect_refusal("compare --smoothings -1", "--smoothings -1");
}

}  // namespace
}  // namespace ricochet::cli
