#include <signal.h>
#include <unistd.h>

#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"
#include "tests/support/test.h"

/// Solvers that a user brings along, by the examples; and the programs among them.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string library = RICOCHET_EXAMPLE_LIBRARY;
const std::string examples = RICOCHET_SOURCE "/examples/solvers/";

/// How an example in Python is called.
std::string python(const std::string& name) {
  return "\"" RICOCHET_PYTHON " " + examples + name + ".py\"";
}

bool python_has(const std::string& module) {
  return call_in_shell(RICOCHET_PYTHON " -c 'import " + module + "'").exit_code == 0;
}

Json run_of(const std::string& arguments) {
  Json run = json_of("solve " + arguments);
  run.erase("seconds");
  return run;
}

/// Expects that the solver does the same twice, spends what it is given, and no more.
void expect_a_good_run(const std::string& solver, const std::string& problem, int budget) {
  const std::string arguments = filled("{} {} --instance 1 --budget {}", solver, problem, budget);
  const Json run = run_of(arguments);
  EXPECT_EQ(run["failure"], "") << solver;
  EXPECT_EQ(run["evaluations"], budget) << solver;
  EXPECT_EQ(run["terminations"].back(), "stopped by the evaluator") << solver;
  EXPECT_EQ(run, run_of(arguments)) << solver;
}

TEST(OwnSolver, IsALibrary) {
  expect_a_good_run(library, "classic-sphere-5", 2000);
  EXPECT_EQ(run_of(library + " classic-sphere-5 --budget 2000")["solved"], true);
  EXPECT_EQ(run_of(library + " hs-71")["formulation"], "penalised") << "it takes no constraints";
}

TEST(OwnSolver, IsAProgram) {
  if (!python_has("json")) GTEST_SKIP() << "no Python";
  expect_a_good_run(python("hill_climber"), "classic-sphere-5", 2000);
  const Json run = run_of(python("hill_climber") + " classic-sphere-5 --budget 2000");
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
  expect_a_good_run(python("nlopt_cobyla"), "hs-71", 300);
  const Json run = run_of(python("nlopt_cobyla") + " hs-71 --budget 1000");
  EXPECT_EQ(run["formulation"], "original") << "with its constraints, an equality among them";
  EXPECT_NEAR(run["objective"].get<double>(), 17.014, 0.01);
}

TEST(OwnSolver, InOctaveOrRSpendsItsBudget) {
  bool ran = false;
  for (const auto& [probe, solver] :
       {std::pair("octave-cli --version", "octave-cli --quiet --no-init-file {}random_search.m"),
        std::pair("Rscript -e 'library(jsonlite)'", "Rscript {}random_search.R")}) {
    if (call_in_shell(probe).exit_code != 0) continue;
    ran = true;
    const std::string quoted = "\"" + filled(solver, examples) + "\"";
    expect_a_good_run(quoted, "classic-sphere-5", 300);
    EXPECT_EQ(run_of(quoted + " count-C1 --budget 50")["evaluations"], 50);
  }
  if (!ran) GTEST_SKIP() << "neither octave-cli nor Rscript with jsonlite";
}

TEST(OwnSolver, IsComparedWithOthers) {
  if (!python_has("json")) GTEST_SKIP() << "no Python";
  expect_refusal(filled("compare --solver {0} --solver {0}", library),
                 "there is another solver of its name, mine");
  out_of(
      "compare --solver {} --solver {} --solver scan --solvers 'nlopt-crs*' "
      "--problems count-C1 --formulations count --budget 20 --instances 2 --out mine",
      library, python("hill_climber"));
  const report::Results data = report::results_in(report::data_in(read("mine/count/data.json")));
  std::set<std::string> names;
  each_row(*data.parts.at("families").at(0).results.table("results"),
           [&](const ricochet::Row& result) {
             names.insert(result.text("solver"));
             EXPECT_EQ(result.number("failed"), 0);
           });
  EXPECT_EQ(names, (std::set<std::string>{"mine", "hill-climber", "scan", "nlopt-crs2"}));
}

TEST(OwnSolver, ThatFailsIsSaidTo) {
  write("mine.sh", "echo '{\"name\": \"mine\"}'; read -r problem; echo oops");
  const auto why = HasSubstr("mine.sh: output line 2 is no JSON");
  const Outcome outcome = call("solve 'sh mine.sh' count-C1 --format json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, why);
  EXPECT_THAT(Json::parse(outcome.out)["failure"].get<std::string>(), why);
  const Outcome words = call("solve 'sh mine.sh' count-C1");
  EXPECT_EQ(words.exit_code, 1);
  EXPECT_THAT(words.out, HasSubstr("no start ended."));
}

TEST(OwnSolver, ThatHangsEndsWithRicochet) {
  write("mine.sh", filled("echo $$ > {}/pid; echo '{{\"name\": \"mine\"}}'; read -r problem\n"
                          "while :; do :; done",
                          here()));
  const Outcome outcome = call_interrupted("INT", "solve 'sh mine.sh' count-C1");
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "ricochet: interrupted\n");
  const pid_t pid = std::stoi(read("pid"));
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

void write_program(const std::string& name, const std::string& text) {
  write(name, text);
  fs::permissions(here() / name, fs::perms::owner_all);
}

/// A user's solver that is edited between two runs of a plan, beside one of the suite.
class EditedSolver : public testing::Test {
 protected:
  void SetUp() override {
    if (!python_has("json")) GTEST_SKIP() << "no Python";
    write("mine.py", one_point);
    write("share", "0.25");
  }

  static std::string path(const std::string& name) { return (here() / name).string(); }

  static std::string script() { return RICOCHET_PYTHON " " + path("mine.py"); }

  static std::string command(const std::string& solver, const std::string& out,
                             const std::string& rest) {
    write("plan.toml", filled("[[part]]\nproblems = \"classic-sphere-5\"\nsolvers = [\"{}\", "
                              "\"random-search\"]\nbudgets = 4\ninstances = 2\n",
                              solver));
    return filled("run plan.toml --out {} --allow-programs {}", out, rest);
  }

  /// What it says on standard error.
  static std::string run(const std::string& solver, const std::string& out,
                         const std::string& rest = "") {
    const Outcome outcome = call(command(solver, out, rest));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  }

  static std::string digest(const std::string& out) { return out_of("digest " + out); }

  /// Expects that runs are kept until `edit`, and then those of the solver are repeated, as in a
  /// fresh folder.
  static void expect_made_anew(const std::string& solver, const std::function<void()>& edit) {
    for (const char* out : {"out", "fresh"}) fs::remove_all(here() / out);
    run(solver, "out");
    const std::string before = digest("out");
    EXPECT_THAT(run(solver, "out", "--resume"), HasSubstr("4 runs are there already")) << solver;
    EXPECT_EQ(digest("out"), before) << solver;
    edit();
    EXPECT_THAT(run(solver, "out", "--resume"),
                AllOf(HasSubstr(changed), HasSubstr("2 runs are there already")))
        << solver;
    EXPECT_NE(digest("out"), before) << solver;
    run(solver, "fresh");
    EXPECT_EQ(digest("out"), digest("fresh")) << solver;
    EXPECT_THAT(run(solver, "out", "--resume"), Not(HasSubstr("changed"))) << solver;
  }

  static void edit_script() {
    std::string text = read("mine.py");
    write("mine.py", text.replace(text.find("0.25"), 4, "0.75"));
  }
};

TEST_F(EditedSolver, IsAScriptAProgramOrWhatASymbolicLinkLeadsTo) {
  expect_made_anew(script(), [&] { edit_script(); });

  const std::string program = "#!" RICOCHET_PYTHON "\n";
  write_program("mine", program + one_point);
  expect_made_anew(path("mine"), [&] { write("mine", program + "# edited\n" + one_point); });

  write("mine.py", one_point);
  fs::create_symlink(here() / "mine.py", here() / "link.py");
  expect_made_anew(RICOCHET_PYTHON " " + path("link.py"), [&] {
    fs::copy(here() / "mine.py", here() / "other.py");
    edit_script();
    fs::rename(here() / "mine.py", here() / "edited.py");
    fs::remove(here() / "link.py");
    fs::create_symlink(here() / "edited.py", here() / "link.py");
  });
}

TEST_F(EditedSolver, ReadsFilesThatItsCommandNames) {
  for (const std::string option : {" ", " --at="}) {
    write("share", "0.25");
    expect_made_anew(script() + option + path("share"), [&] { write("share", "0.75"); });
  }
}

TEST_F(EditedSolver, IsFoundOnThePath) {
  const auto install = [&](const std::string& comment) {
    write_program("bin/brought", "#!" RICOCHET_PYTHON "\n" + comment + one_point);
  };
  install("");
  const std::string before = std::getenv("PATH");
  setenv("PATH", (path("bin") + ":" + before).c_str(), 1);
  expect_made_anew("brought " + path("share"), [&] { install("# edited\n"); });
  setenv("PATH", before.c_str(), 1);
}

TEST_F(EditedSolver, IsALibrary) {
  fs::copy(library, here() / "mine.so");
  expect_made_anew(path("mine.so"), [&] {
    fs::remove(here() / "mine.so");  // a compiler writes a new file, too
    fs::copy(library, here() / "mine.so");
    std::ofstream(here() / "mine.so", std::ios::app) << "edited";
  });
}

TEST_F(EditedSolver, IsALibraryThatBringsAnother) {
  const auto compiled = [&](const std::string& files) {
    return call_in_shell("cc -shared -fPIC -I " RICOCHET_SOURCE "/include " + files).exit_code == 0;
  };
  const auto core = [&](const std::string& share) {
    write("core.c", "double share(void) { return " + share + "; }\n");
    return compiled("core.c -o libmine_core.so");
  };
  write("mine.c", R"(#include <ricochet/ricochet.h>
double share(void);
static const char* solve(ricochet_problem* p, double* x) {
  double f;
  for (int i = 0; i < p->dimension; ++i) x[i] = p->lower[i] + share() * (p->upper[i] - p->lower[i]);
  p->values(p, x, &f, 0);
  return "end";
}
const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "mine", "1.0", 0, 0, 0, 0, solve};
)");
  if (!core("0.25") || !compiled("mine.c -o mine.so -L. -lmine_core -Wl,-rpath,'$ORIGIN'")) {
    GTEST_SKIP() << "no C compiler";
  }
  expect_made_anew(path("mine.so"), [&] { EXPECT_TRUE(core("0.75")); });
}

TEST_F(EditedSolver, HasItsRunsTakenOverOnlyIfItIsTheSame) {
  run(script(), "out");
  const auto there = HasSubstr("4 runs are there already");
  write("mine.py", one_point);  // only touched
  EXPECT_THAT(run(script(), "out", "--resume"), there);
  write("copy.py", one_point);
  EXPECT_THAT(run(RICOCHET_PYTHON " " + path("copy.py"), "moved", "--from out"),
              AllOf(there, Not(HasSubstr("changed"))));
  edit_script();
  EXPECT_THAT(run(script(), "from", "--from out"), HasSubstr(changed));
  run(script(), "fresh");
  EXPECT_EQ(digest("from"), digest("fresh"));
  // With other options it is another one.
  run(script() + " " + path("share"), "options");
  write("shares", "0.75");
  EXPECT_THAT(run(script() + " " + path("shares"), "other", "--from options"), HasSubstr(changed));
}

TEST_F(EditedSolver, IsComparedAnew) {
  const std::string compare = filled(
      "compare --problems classic-sphere-5 --solvers random-search --solver '{}' --budget 4 "
      "--instances 2 --out out",
      script());
  out_of(compare);
  edit_script();
  const std::string earlier = read("out/data.json");
  EXPECT_EQ(call("report out").err, "");
  EXPECT_THAT(call(compare).err, HasSubstr("mine changed since these runs: "));
  const std::string later = read("out/data.json");
  write("out/data.json", earlier);
  EXPECT_THAT(call("report out").err, HasSubstr("has other runs than this report"));
  write("out/data.json", later);
  out_of("submit out --solvers '*' --out out.archive --allow-programs");
  write("mine.py", one_point);
  EXPECT_THAT(call("compare --solver '{}' --against out.archive --out against", script()).err,
              HasSubstr("mine changed since these runs: "));
}

TEST_F(EditedSolver, IsNotMergedWithItself) {
  run(script(), "one", "--shard 1/2");
  edit_script();
  run(script(), "two", "--shard 2/2");
  expect_refusal("merge all.sqlite one two",
                 "the first has runs of another mine, made of other files");
}

TEST_F(EditedSolver, IsNamedByAReplay) {
  run(script(), "out");
  edit_script();
  const Outcome again = call(
      "replay out classic-sphere-5/original/plain/mine/4/n/1/0 --allow-programs --format json");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("mine changed since this run was made"));
  EXPECT_EQ(Json::parse(again.out)["solver_changed"], true);
}

TEST_F(EditedSolver, StopsTheRunsIfItChangesMeanwhile) {
  std::string text = one_point;
  text.replace(text.find("    problem ="), 0, "    open(__file__, 'a').write('# edited\\n')\n");
  write("mine.py", text);
  // The script may complain, too: that nobody listens any more.
  const Outcome outcome = call(command(script(), "out", "--quiet"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("mine.py: changed while runs of mine were made"));
  out_of("export out --format csv --out csv");
  EXPECT_THAT(read("csv/runs.csv"), Not(HasSubstr(",mine,")));
}

/// Two programs that leave a file when they are started, and a plan that names them.
class Programs : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string name : {"first", "second"}) {
      write(name + ".sh",
            filled("touch {0}/{1}.started\necho '{{\"name\": \"{1}\"}}'\n"
                   "while read -r problem; do\n"
                   "  echo '{{\"ask\": [1]}}'; read -r answer; echo '{{\"done\": \"done\"}}'\n"
                   "done\n",
                   here(), name));
    }
    write("plan.toml",
          "name = \"programs\"\n[[part]]\nproblems = [\"count-C1\"]\nformulations = [\"count\"]\n"
          "solvers = [\"scan\", \"sh first.sh\", \"sh second.sh\"]\nbudgets = [5]\n"
          "instances = 2\n");
  }

  static bool started(const std::string& name) { return exists(name + ".started"); }
  static bool any_started() { return started("first") || started("second"); }
  static void forget_starts() {
    for (const char* file : {"first.started", "second.started"}) fs::remove(here() / file);
  }
};

TEST_F(Programs, AreListedByACheckThatStartsNone) {
  const std::string check = out_of("plan check plan.toml");
  EXPECT_THAT(check, AllOf(HasSubstr("run would start: sh first.sh\n"),
                           HasSubstr("run would start: sh second.sh\n"), HasSubstr("; at least ")));
  const Json data = json_of("plan check plan.toml");
  EXPECT_EQ(data["programs"], (Json{"sh first.sh", "sh second.sh"}));
  EXPECT_EQ(data["runs"], 6);
  EXPECT_EQ(data["at_least"], true) << "they take a time that a check does not know";
  EXPECT_THAT(out_of("plan slurm plan.toml"),
              AllOf(HasSubstr("# It starts: sh second.sh\n"), HasSubstr(" --allow-programs "),
                    HasSubstr("# The time below is at least needed")));
  EXPECT_FALSE(any_started());
  EXPECT_THAT(out_of("plan check quick"), HasSubstr("; about "));
  EXPECT_THAT(out_of("plan slurm quick"),
              AllOf(Not(HasSubstr("at least")), Not(HasSubstr("--allow-programs"))));
}

TEST_F(Programs, AreShownInALineEach) {
  write("odd.toml",
        "[[part]]\nproblems = \"hs-71\"\n"
        "solvers = [\"scan\", \"sh -c '\\u001b[31m\\ntouch evil'\"]\nbudgets = 5\n");
  const std::string shown = "sh -c '\\x1b[31m\\x0atouch evil'\n";
  EXPECT_THAT(out_of("plan check odd.toml"), HasSubstr("run would start: " + shown));
  EXPECT_THAT(out_of("plan slurm odd.toml"), HasSubstr("# It starts: " + shown))
      << "else its second line would be a command";
}

TEST_F(Programs, OfAPlanRunOnlyWhereTheyAreAllowed) {
  expect_refusal("run plan.toml --out out",
                 "plan.toml: names programs, which run with your rights: sh first.sh; "
                 "sh second.sh; add --allow-programs if you trust them");
  EXPECT_FALSE(started("first"));
  EXPECT_FALSE(exists("out"));
  const Outcome run = call("run plan.toml --out out --allow-programs");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(testing::StartsWith("starts sh first.sh\nstarts sh second.sh\n"),
                             HasSubstr("\nabout ")));
  EXPECT_TRUE(started("first"));
}

TEST_F(Programs, OfAStoreAreStartedForTheirOwnRunsOnly) {
  out_of("run plan.toml --out out --allow-programs");
  int seen = 0;
  for (int number = 1; number <= 6; ++number) {
    forget_starts();
    const std::string replay = filled("replay out {}", number);
    const Outcome unasked = call(replay);
    EXPECT_FALSE(any_started());
    const Json again = json_of(replay + " --allow-programs");
    EXPECT_EQ(again["same"], true);
    const std::string solver = again["solver"];
    EXPECT_EQ(started("first"), solver == "first");
    EXPECT_EQ(started("second"), solver == "second");
    EXPECT_EQ(unasked.exit_code, solver == "scan" ? 0 : 2) << solver;
    if (solver == "scan") continue;
    ++seen;
    EXPECT_THAT(unasked.err, HasSubstr("run with your rights: sh " + solver + ".sh; add"));
  }
  EXPECT_EQ(seen, 4);
  forget_starts();
  for (const std::string reading :
       {"digest out", "export out --format csv --out csv", "merge all.sqlite out"}) {
    call(reading);
    EXPECT_FALSE(any_started()) << reading;
  }
}

TEST_F(Programs, GivenByACommandNeedNoPermission) {
  out_of("solve 'sh first.sh' count-C1");
  EXPECT_TRUE(started("first"));
}

}  // namespace
}  // namespace ricochet::cli
