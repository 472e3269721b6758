#include <signal.h>
#include <unistd.h>

#include "tests/app/tool.h"

/// Solvers that a user brings along, by the examples, and what holds where they are edited.
namespace ricochet::cli {
namespace {

const std::string library = RICOCHET_EXAMPLE_LIBRARY;
const std::string examples = RICOCHET_SOURCE "/examples/solvers/";

/// How an example in Python is called.
std::string python(const std::string& name) {
  return "\"" RICOCHET_PYTHON " " + examples + name + ".py\"";
}

bool python_has(const std::string& module) {
  return call_in_shell(RICOCHET_PYTHON " -c 'import " + module + "'").exit_code == 0;
}

/// A run, which must be the same twice, and spend what the solver is given and no more.
Json good_run(const std::string& solver, const std::string& problem, int budget) {
  SCOPED_TRACE(solver);
  Json runs[2];
  for (Json& run : runs) {
    run = json_of("solve {} {} --instance 1 --budget {}", solver, problem, budget);
    run.erase("seconds");
  }
  EXPECT_EQ(runs[0], runs[1]);
  EXPECT_EQ(runs[0]["failure"], "");
  EXPECT_EQ(runs[0]["evaluations"], budget);
  EXPECT_EQ(runs[0]["terminations"].back(), "stopped by the evaluator");
  return runs[0];
}

TEST(OwnSolver, IsALibrary) {
  EXPECT_EQ(good_run(library, "classic-sphere-5", 2000)["solved"], true);
  EXPECT_EQ(json_of("solve {} hs-71", library)["formulation"], "penalised")
      << "it takes no constraints";
}

TEST(OwnSolver, IsAProgram) {
  if (!python_has("json")) GTEST_SKIP() << "no Python";
  const Json run = good_run(python("hill_climber"), "classic-sphere-5", 2000);
  EXPECT_EQ((Json{run["solver"], run["solved"], run["returned_solved"]}),
            (Json{"hill-climber", true, true}));
}

TEST(OwnSolver, IsOneOfScipy) {
  if (!python_has("scipy")) GTEST_SKIP() << "no python3-scipy";
  for (const auto& [problem, budget] : {std::pair("classic-sphere-5", 300), {"count-C1", 200}}) {
    EXPECT_EQ(good_run(python("scipy_differential_evolution"), problem, budget)["solver"],
              "scipy-differential-evolution");
  }
}

TEST(OwnSolver, IsOneOfNloptInPython) {
  if (!python_has("nlopt")) GTEST_SKIP() << "no python3-nlopt";
  const Json run = good_run(python("nlopt_cobyla"), "hs-71", 1000);
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
    for (const char* problem : {"classic-sphere-5", "count-C1"}) {
      good_run("\"" + filled(solver, examples) + "\"", problem, 50);
    }
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
  const auto families = results_of("mine/count").parts.at("families");
  std::set<std::string> names;
  each_row(*families.at(0).results.table("results"), [&](const Row& result) {
    names.insert(result.text("solver"));
    EXPECT_EQ(result.number("failed"), 0);
  });
  EXPECT_THAT(names, ElementsAre("hill-climber", "mine", "nlopt-crs2", "scan"));
}

TEST(OwnSolver, ThatFailsIsSaidTo) {
  write("mine.sh", "echo '{\"name\": \"mine\"}'; read -r problem; echo oops");
  const auto why = HasSubstr("mine.sh: output line 2 is no JSON");
  const Outcome outcome = call("solve 'sh mine.sh' count-C1 --format json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, why);
  EXPECT_THAT(Json::parse(outcome.out)["failure"].get<std::string>(), why);
  EXPECT_THAT(call("solve 'sh mine.sh' count-C1").out, HasSubstr("no start ended."));
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
    SCOPED_TRACE(solver);
    for (const char* out : {"out", "fresh"}) fs::remove_all(here() / out);
    run(solver, "out");
    const std::string before = digest("out");
    EXPECT_THAT(run(solver, "out", "--resume"), HasSubstr("4 runs are there already"));
    EXPECT_EQ(digest("out"), before);
    edit();
    EXPECT_THAT(run(solver, "out", "--resume"),
                AllOf(HasSubstr(changed), HasSubstr("2 runs are there already")));
    EXPECT_NE(digest("out"), before);
    run(solver, "fresh");
    EXPECT_EQ(digest("out"), digest("fresh"));
    EXPECT_THAT(run(solver, "out", "--resume"), Not(HasSubstr("changed")));
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
  fs::create_symlink("mine.py", here() / "link.py");
  expect_made_anew(RICOCHET_PYTHON " " + path("link.py"), [&] {
    edit_script();
    fs::rename(here() / "mine.py", here() / "edited.py");
    fs::remove(here() / "link.py");
    fs::create_symlink("edited.py", here() / "link.py");
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
    const std::string before = read("mine.so");
    fs::remove(here() / "mine.so");  // a compiler writes a new file, too
    write("mine.so", before + "edited");
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
  write("out/data.json", earlier);
  EXPECT_THAT(call("report out").err, HasSubstr("has other runs than this report"));
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
  text.insert(text.find("    problem ="), "    open(__file__, 'a').write('# edited\\n')\n");
  write("mine.py", text);
  // The script may complain, too: that nobody listens any more.
  const Outcome outcome = call(command(script(), "out", "--quiet"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("mine.py: changed while runs of mine were made"));
  out_of("export out --format csv --out csv");
  EXPECT_THAT(read("csv/runs.csv"), Not(HasSubstr(",mine,")));
}

}  // namespace
}  // namespace ricochet::cli
