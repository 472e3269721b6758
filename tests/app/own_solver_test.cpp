#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"

/// Solvers that a user brings along, by the examples.
namespace ricochet::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

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
  const report::Results data =
      report::results_in(report::data_in(read(folder / "count" / "data.json")));
  std::set<std::string> names;
  each_row(*data.parts.at("families").at(0).results.table("results"),
           [&](const ricochet::Row& result) {
             names.insert(result.text("solver"));
             EXPECT_EQ(result.number("failed"), 0);
           });
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

/// A solver in Python that evaluates one point, as far in the box as the file in its second
/// argument or --at=FILE says, or else as SHARE says.
constexpr auto one_point = R"(import json, sys
SHARE = 0.25
for word in sys.argv[1:]:
    SHARE = float(open(word.split('=')[-1]).read())
print(json.dumps({"name": "mine", "version": "1"}), flush=True)
for line in sys.stdin:
    problem = json.loads(line)
    x = [a + SHARE * (b - a) for a, b in zip(problem["lower"], problem["upper"])]
    print(json.dumps({"ask": x}), flush=True)
    sys.stdin.readline()
    print(json.dumps({"done": "one point", "point": x}), flush=True)
)";

constexpr auto changed = "mine changed since these runs: 2 runs are repeated";

/// A user's solver that is edited between two runs of a plan, beside one of the suite.
class EditedSolver : public testing::Test {
 protected:
  void SetUp() override {
    if (!python_has("json")) GTEST_SKIP() << "no Python";
    write(folder_, "mine.py", one_point);
    write(folder_, "share", "0.25");
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string script() const { return RICOCHET_PYTHON " " + path("mine.py"); }

  std::string command(const std::string& solver, const std::string& out,
                      const std::string& rest) const {
    write(folder_, "plan.toml",
          fmt::format("[[part]]\nproblems = \"classic-sphere-5\"\nsolvers = [\"{}\", "
                      "\"random-search\"]\nbudgets = 4\ninstances = 2\n",
                      solver));
    return fmt::format("run {} --out {} --allow-programs {}", path("plan.toml"), path(out), rest);
  }

  Outcome run(const std::string& solver, const std::string& out, const std::string& rest = "") {
    const Outcome outcome = call(command(solver, out, rest));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome;
  }

  std::string digest(const std::string& out) {
    return call("digest " + path(out) + "/runs.sqlite").out;
  }

  /// Expects that runs are kept until `edit`, and then those of the solver are repeated, as in a
  /// fresh folder.
  void expect_made_anew(const std::string& solver, const std::function<void()>& edit) {
    run(solver, "out");
    const std::string before = digest("out");
    EXPECT_THAT(run(solver, "out", "--resume").err, HasSubstr("4 runs are there already"));
    EXPECT_EQ(digest("out"), before);
    edit();
    const Outcome again = run(solver, "out", "--resume");
    EXPECT_THAT(again.err, HasSubstr(changed));
    EXPECT_THAT(again.err, HasSubstr("2 runs are there already"));
    EXPECT_NE(digest("out"), before);
    run(solver, "fresh");
    EXPECT_EQ(digest("out"), digest("fresh"));
    EXPECT_THAT(run(solver, "out", "--resume").err, Not(HasSubstr("changed")));
  }

  void edit_script() const {
    std::string text = read(folder_ / "mine.py");
    text.replace(text.find("0.25"), 4, "0.75");
    write(folder_, "mine.py", text);
  }

  const std::filesystem::path folder_ = fresh_folder();
};

TEST_F(EditedSolver, IsAScript) {
  expect_made_anew(script(), [&] { edit_script(); });
}

TEST_F(EditedSolver, IsAProgramOfItsOwn) {
  write(folder_, "mine", "#!" RICOCHET_PYTHON "\n" + std::string(one_point));
  std::filesystem::permissions(folder_ / "mine", std::filesystem::perms::owner_all);
  expect_made_anew(path("mine"), [&] {
    write(folder_, "mine", "#!" RICOCHET_PYTHON "\n# edited\n" + std::string(one_point));
  });
}

TEST_F(EditedSolver, ReadsAFileThatItsCommandNames) {
  expect_made_anew(script() + " " + path("share"), [&] { write(folder_, "share", "0.75"); });
}

TEST_F(EditedSolver, ReadsAFileOfAnOption) {
  expect_made_anew(script() + " --at=" + path("share"), [&] { write(folder_, "share", "0.75"); });
}

TEST_F(EditedSolver, IsWhereASymbolicLinkLeads) {
  std::filesystem::create_symlink(folder_ / "mine.py", folder_ / "link.py");
  expect_made_anew(RICOCHET_PYTHON " " + path("link.py"), [&] {
    std::filesystem::copy(folder_ / "mine.py", folder_ / "other.py");
    edit_script();
    std::filesystem::rename(folder_ / "mine.py", folder_ / "edited.py");
    std::filesystem::remove(folder_ / "link.py");
    std::filesystem::create_symlink(folder_ / "edited.py", folder_ / "link.py");
  });
}

TEST_F(EditedSolver, IsFoundOnThePath) {
  std::filesystem::create_directory(folder_ / "bin");
  const auto install = [&](const std::string& comment) {
    write(folder_ / "bin", "brought", "#!" RICOCHET_PYTHON "\n" + comment + one_point);
    std::filesystem::permissions(folder_ / "bin" / "brought", std::filesystem::perms::owner_all);
  };
  install("");
  const std::string before = std::getenv("PATH");
  setenv("PATH", (path("bin") + ":" + before).c_str(), 1);
  expect_made_anew("brought " + path("share"), [&] { install("# edited\n"); });
  setenv("PATH", before.c_str(), 1);
}

TEST_F(EditedSolver, IsALibrary) {
  std::filesystem::copy(library, folder_ / "mine.so");
  expect_made_anew(path("mine.so"), [&] {
    std::filesystem::remove(folder_ / "mine.so");  // a compiler writes a new file, too
    std::filesystem::copy(library, folder_ / "mine.so");
    std::ofstream(folder_ / "mine.so", std::ios::app) << "edited";
  });
}

TEST_F(EditedSolver, IsALibraryThatBringsAnother) {
  const auto compiled = [&](const std::string& source, const std::string& rest) {
    return std::system(fmt::format("cd {} && cc -shared -fPIC -I {}/include {} {} 2>&1",
                                   folder_.string(), RICOCHET_SOURCE, source, rest)
                           .c_str()) == 0;
  };
  const auto core = [&](const char* share) {
    write(folder_, "core.c", fmt::format("double share(void) {{ return {}; }}\n", share));
    return compiled("core.c", "-o libmine_core.so");
  };
  write(folder_, "mine.c", R"(#include <ricochet/ricochet.h>
double share(void);
static const char* solve(ricochet_problem* p, double* x) {
  double f;
  for (int i = 0; i < p->dimension; ++i) x[i] = p->lower[i] + share() * (p->upper[i] - p->lower[i]);
  p->values(p, x, &f, 0);
  return "end";
}
const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "mine", "1.0", 0, 0, 0, 0, solve};
)");
  if (!core("0.25") || !compiled("mine.c", "-o mine.so -L. -lmine_core -Wl,-rpath,'$ORIGIN'")) {
    GTEST_SKIP() << "no C compiler";
  }
  expect_made_anew(path("mine.so"), [&] { EXPECT_TRUE(core("0.75")); });
}

TEST_F(EditedSolver, IsKeptIfItIsOnlyTouchedOrMoved) {
  run(script(), "out");
  const std::string before = digest("out");
  write(folder_, "mine.py", one_point);
  EXPECT_THAT(run(script(), "out", "--resume").err, HasSubstr("4 runs are there already"));
  write(folder_, "copy.py", one_point);
  const Outcome moved =
      run(RICOCHET_PYTHON " " + path("copy.py"), "moved", "--from " + path("out/runs.sqlite"));
  EXPECT_THAT(moved.err, HasSubstr("4 runs are there already"));
  EXPECT_THAT(moved.err, Not(HasSubstr("changed")));
}

TEST_F(EditedSolver, IsAnotherOneWithOtherOptions) {
  run(script() + " " + path("share"), "out");
  write(folder_, "shares", "0.75");
  const Outcome other =
      run(script() + " " + path("shares"), "other", "--from " + path("out/runs.sqlite"));
  EXPECT_THAT(other.err, HasSubstr(changed));
}

TEST_F(EditedSolver, HasNoRunsTakenOverFromBefore) {
  run(script(), "out");
  edit_script();
  EXPECT_THAT(run(script(), "from", "--from " + path("out/runs.sqlite")).err, HasSubstr(changed));
  run(script(), "fresh");
  EXPECT_EQ(digest("from"), digest("fresh"));
}

TEST_F(EditedSolver, IsComparedAnew) {
  const std::string compare = fmt::format(
      "compare --problems classic-sphere-5 --solvers random-search --solver '{}' "
      "--budget 4 --instances 2 --out {}",
      script(), path("out"));
  EXPECT_EQ(call(compare).exit_code, 0);
  edit_script();
  std::filesystem::copy(folder_ / "out" / "data.json", folder_ / "earlier.json");
  EXPECT_EQ(call("report " + path("out")).err, "");
  EXPECT_THAT(call(compare).err, HasSubstr("mine changed since these runs: "));
  const auto overwrite = std::filesystem::copy_options::overwrite_existing;
  std::filesystem::copy(folder_ / "out" / "data.json", folder_ / "later.json");
  std::filesystem::copy(folder_ / "earlier.json", folder_ / "out" / "data.json", overwrite);
  EXPECT_THAT(call("report " + path("out")).err, HasSubstr("has other runs than this report"));
  std::filesystem::copy(folder_ / "later.json", folder_ / "out" / "data.json", overwrite);
  const std::string archive = path("out.archive");
  ASSERT_EQ(call(fmt::format("submit {}/runs.sqlite --solvers '*' --out {} --allow-programs",
                             path("out"), archive))
                .exit_code,
            0);
  const std::string against = fmt::format("compare --solver '{}' --against {} --out {}", script(),
                                          archive, path("against"));
  write(folder_, "mine.py", one_point);
  EXPECT_THAT(call(against).err, HasSubstr("mine changed since these runs: "));
}

TEST_F(EditedSolver, IsNotMergedWithItself) {
  run(script(), "one", "--shard 1/2");
  edit_script();
  run(script(), "two", "--shard 2/2");
  expect_refusal(fmt::format("merge {} {} {}", path("all.sqlite"), path("one/runs.sqlite"),
                             path("two/runs.sqlite")),
                 "the first has runs of another mine, made of other files");
}

TEST_F(EditedSolver, IsNamedByAReplay) {
  run(script(), "out");
  edit_script();
  const std::string key = "classic-sphere-5/original/plain/mine/4/n/1/0";
  const Outcome again = call(
      fmt::format("replay {} {} --allow-programs --format json", path("out/runs.sqlite"), key));
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("mine changed since this run was made"));
  EXPECT_EQ(json::parse(again.out)["solver_changed"], true);
}

TEST_F(EditedSolver, StopsTheRunsIfItChangesMeanwhile) {
  std::string text = one_point;
  text.replace(text.find("    problem ="), 0, "    open(__file__, 'a').write('# edited\\n')\n");
  write(folder_, "mine.py", text);
  // The script may complain, too: that nobody listens any more.
  const Outcome outcome = call(command(script(), "out", "--quiet"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("mine.py: changed while runs of mine were made"));
  EXPECT_EQ(
      call(fmt::format("export {} --format csv --out {}", path("out/runs.sqlite"), path("csv")))
          .exit_code,
      0);
  EXPECT_THAT(read(folder_ / "csv" / "runs.csv"), Not(HasSubstr(",mine,")));
}

}  // namespace
}  // namespace ricochet::cli
