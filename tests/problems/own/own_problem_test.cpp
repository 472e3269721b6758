#include "problems/own/own_problem.h"

#include <sys/wait.h>

#include <csignal>
#include <regex>

#include "ricochet/run.h"
#include "tests/support/files.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"

namespace ricochet::own {
namespace {

const std::string variables = R"(
[[variable]]
name = "a"
lower = 0.5
upper = 8
start = 2
scale = "logarithmic"
[[variable]]
name = "b"
lower = -3
upper = 3
[[constraint]]
name = "disk"
[[constraint]]
name = "line"
kind = "equality"
[[constraint]]
name = "side"
kind = "binary"
)";

/// What the programs of these tests compute, by formulas: objective, then the constraints.
Vector expected(double a, double b) {
  return Vector{{a * a + 3 * b, a * a + b * b - 9, a - 2 * b, b > 1 ? 1.0 : 0.0}};
}

const std::string formulas = "$1*$1+3*$2, $1*$1+$2*$2-9, $1-2*$2, ($2>1)";

/// A program that answers each line of JSON as `expected` has it.
const std::string answering = R"(import json, sys
for line in sys.stdin:
    a, b = json.loads(line)["x"]
    told = {"objective": a*a + 3*b, "constraints": [a*a + b*b - 9, a - 2*b, b <= 1]}
    if json.loads(line).get("derivatives"):
        told.update(gradient=[2*a, 3], jacobian=[[2*a, 2*b], [1, -2], [0, 0]])
    print(json.dumps(told), flush=True)
)";

class OwnProblemTest : public TemporaryFolder {
 protected:
  /// A problem file of these tests with this [program], and `head` before it.
  ProblemFile file(const std::string& program, const std::string& head = "",
                   const std::string& rest = variables) const {
    return problem_file_from(
        fmt::format("name = \"p\"\n{}\n[program]\n{}\n{}", head, program, rest),
        folder_ / "p.toml");
  }

  void write_program(const std::string& name, const std::string& text) const {
    fs::permissions(write_file(folder_ / name, text), fs::perms::owner_all);
  }

  /// A problem whose command is a Python program of this text.
  OwnProblem by_python(const std::string& text, const std::string& program = "",
                       const std::string& head = "", const std::string& rest = variables) const {
    write_file(folder_ / "p.py", text);
    return OwnProblem(file("command = 'python3 p.py'\n" + program, head, rest));
  }

  /// The reasons for which evaluations failed, each with a newline.
  static std::string reasons(const OwnProblem& own) {
    std::string text;
    for (const FailureCount& each : own.store().failures()) text += each.reason + "\n";
    return text;
  }
};

TEST_F(OwnProblemTest, HasTheSameValuesByEveryWayIn) {
  write_program("plain", "#!/bin/sh\nawk '{ OFMT = \"%.17g\"; print " + formulas + " }' $1\n");
  write_program("files",
                "#!/bin/sh\nawk '{ OFMT = \"%.17g\"; print 7, $1-2*$2, "
                "$1*$1+3*$2; print $1*$1+$2*$2-9; print ($2>1), \"label\" }' $1 > $2\n");
  write_program(
      "dakota",
      "#!/bin/sh\nawk '/ a$/ { a = $1 } / b$/ { b = $1 } END { OFMT = \"%.17g\"; print a*a+3*b, "
      "\"f\"; "
      "print a*a+b*b-9, \"disk\"; print a-2*b, \"line\"; print (b>1), \"side\" }' $1 > $2\n");
  write_file(folder_ / "answers.py", answering);
  const std::string ways[] = {"command = 'python3 answers.py'", "executable = './plain'",
                              "executable = './files @in @out'\noutputs = ['ignored', 'line', "
                              "'objective', 'disk', 'side']",
                              "executable = './dakota'\nformat = 'dakota'",
                              "library = '" RICOCHET_OWN_LIBRARY "'"};
  std::mt19937 random(55);
  std::uniform_real_distribution<double> of_a(0.5, 8), of_b(-3, 3);
  for (const std::string& way : ways) {
    SCOPED_TRACE(way);
    const OwnProblem own(file(way));
    const Problem& problem = own.problem();
    EXPECT_EQ(problem.equalities, 1);
    for (int k = 0; k < 5; ++k) {
      const double a = of_a(random), b = of_b(random);
      const Vector wanted = expected(own.file().stated(Vector{{std::log(a), b}})[0], b);
      const Values got = problem.evaluate(Vector{{std::log(a), b}});
      EXPECT_NEAR(got.objective, wanted[0], 1e-12);
      // The equality comes first; binary is -1 where it holds.
      EXPECT_NEAR(got.constraints[0], wanted[2], 1e-12);
      EXPECT_NEAR(got.constraints[1], wanted[1], 1e-12);
      EXPECT_EQ(got.constraints[2], wanted[3] > 0 ? 1 : -1);
    }
    EXPECT_EQ(reasons(own), "");
  }
}

TEST_F(OwnProblemTest, HasDerivativesByTheCoordinatesThatASolverSees) {
  const OwnProblem own = by_python(answering, "derivatives = true", "goal = 'maximise'");
  const Problem& problem = own.problem();
  const Vector at{{std::log(3.0), 0.7}};
  const Derivatives told = problem.differentiate(at);
  EXPECT_NEAR(told.values.objective, -(9 + 2.1), 1e-12) << "maximised";
  for (Eigen::Index i = 0; i < 2; ++i) {
    constexpr double h = 1e-6;
    Vector after = at, before = at;
    after[i] += h;
    before[i] -= h;
    const Values high = problem.evaluate(after), low = problem.evaluate(before);
    EXPECT_NEAR(told.gradient[i], (high.objective - low.objective) / (2 * h), 1e-8);
    const Vector slopes = (high.constraints - low.constraints) / (2 * h);
    EXPECT_LT((told.jacobian.col(i) - slopes).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_F(OwnProblemTest, HasDifferencesForResidualsWithoutDerivatives) {
  const std::string rest =
      "[[variable]]\nname = 'a'\nlower = 1\nupper = 100\nscale = 'logarithmic'\n"
      "[[variable]]\nname = 'b'\nlower = 0\nupper = 4\n";
  const OwnProblem own = by_python(
      "import json, sys\nfor line in sys.stdin:\n"
      "    a, b = json.loads(line)['x']\n"
      "    print(json.dumps({'residuals': [a*b - 6, a - b, b*b]}), flush=True)\n",
      "residuals = 3", "", rest);
  for (const double b : {1.5, 4.0}) {  // within the box, and at its end
    const Residuals told = own.problem().residuals(Vector{{std::log(2.0), b}});
    const Vector values{{2 * b - 6, 2 - b, b * b}};
    EXPECT_LT((told.values - values).norm(), 1e-12);
    EXPECT_NEAR(own.problem().evaluate(Vector{{std::log(2.0), b}}).objective,
                values.squaredNorm() / 2, 1e-12);
    const Matrix exact{{2 * b, 2}, {2, -1}, {0, 2 * b}};  // by ln a and b
    EXPECT_LT((told.jacobian - exact).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST_F(OwnProblemTest, ComputesAPointOnce) {
  write_file(folder_ / "count.py", "import sys\nopen('calls', 'a').write('.')\n" + answering);
  write_program("once", "#!/bin/sh\nprintf . >> calls\nawk '{ print " + formulas + " }' $1\n");
  const Vector x{{0.3, 0.2}};
  for (int round = 0; round < 3; ++round) {
    const OwnProblem own(file("executable = './once'"));
    EXPECT_EQ(own.problem().evaluate(x).constraints.size(), 3);
    EXPECT_EQ(own.counts().computed, round == 0 ? 1 : 0);
    EXPECT_EQ(own.counts().found, round == 0 ? 0 : 1);
  }
  EXPECT_EQ(ricochet::text_of(folder_ / "calls"), ".");
  write_program("once", "#!/bin/sh\nprintf . >> calls\nawk '{ print 1, 2, 3, 0 }' $1\n");
  EXPECT_EQ(OwnProblem(file("executable = './once'")).problem().evaluate(x).objective, 1)
      << "of another program";
  EXPECT_EQ(ricochet::text_of(folder_ / "calls"), "..");
}

TEST_F(OwnProblemTest, ChargesAFailureToItsOwnEvaluation) {
  // What a program does at its second point.
  const std::pair<std::string, std::string> misdeeds[] = {
      {"sys.exit(3)", "ended with exit code 3"},
      {"sys.exit('no licence')", "ended with exit code 1; its last words: no licence"},
      {"os.kill(os.getpid(), 11)", "was ended by signal 11"},
      {"time.sleep(60)", "took too long"},
      {"os.fork(); time.sleep(60)", "took too long"},
      {"print('{\"objective\": 1e999, \"constraints\": [0, 0, 0]}', flush=True); continue",
       "a number that is too large"},
      {"print('1.5 2.5', flush=True); continue", "no JSON"},
      {"print('[1, 2]', flush=True); continue", "no JSON object"},
      {"print('{}', flush=True); continue", "objective is missing"},
      {"print('{\"objective\": \"high\", \"constraints\": [0, 0, 0]}', flush=True); continue",
       "of type string"},
      {"print('{\"objective\": 1, \"constraints\": [0]}', flush=True); continue",
       "constraints must have 3 numbers"},
      {"print('{\"objective\": 1, \"mood\": 1}', flush=True); continue", "mood is not expected"},
      {"print('{\"error\": \"diverged\"}', flush=True); continue", "said: diverged"},
      {"print('x' * 2000000, flush=True); continue", "no JSON: xxx"},
      {"print('x' * 5000000, flush=True); continue", "4 MiB"},
      {"bytearray(10**10); continue", "MemoryError"}};
  for (const auto& [misdeed, reason] : misdeeds) {
    SCOPED_TRACE(misdeed);
    fs::remove(folder_ / "p.evaluations");
    const OwnProblem own = by_python(
        "import json, os, sys, time\nfor line in sys.stdin:\n"
        "    a, b = json.loads(line)['x']\n"
        "    if b == 0.25:\n        " +
            misdeed +
            "\n"
            "    print(json.dumps({'objective': a, 'constraints': [b, 0, 0]}), flush=True)\n",
        "seconds = 4\nmegabytes = 400");
    for (const double b : {0.5, 0.25, 0.75}) {
      const Values got = own.problem().evaluate(Vector{{0, b}});
      EXPECT_EQ(std::isnan(got.objective), b == 0.25);
      EXPECT_EQ(got.constraints.array().isNaN().all(), b == 0.25);
    }
    EXPECT_THAT(reasons(own), HasSubstr(reason));
    EXPECT_EQ(own.counts().failed, 1);
  }
}

TEST_F(OwnProblemTest, DoesNotTakeALineThatItDidNotAskFor) {
  const OwnProblem own = by_python(
      "import json, sys\nfor line in sys.stdin:\n"
      "    a, b = json.loads(line)['x']\n"
      "    for _ in range(2): print(json.dumps({'objective': a, 'constraints': [b, 0, 0]}), "
      "flush=True)\n");
  EXPECT_EQ(own.problem().evaluate(Vector{{0, 0.5}}).objective, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_TRUE(std::isnan(own.problem().evaluate(Vector{{0, 0.25}}).objective));
  EXPECT_THAT(reasons(own), HasSubstr("a line that it was not asked for"));
}

TEST_F(OwnProblemTest, ReadsNumbersAsProgramsWriteThem) {
  const std::tuple<std::string, double, std::string> cases[] = {
      {"1.5 0 0 0", 1.5, ""},
      {"+1.5D+01, 0, 0; 0", 15, ""},
      {"nan 0 0 0", NAN, ""},
      {"-nan(ind) 0 0 0", NAN, ""},
      {"1.#QNAN 0 0 0", NAN, ""},
      {"1 0 0", NAN, "gave 3 numbers, not 4"},
      {"1,5 0 0 0", NAN, "gave 5 numbers"},
      {"ERROR: singular", NAN, "gave \"ERROR:\""}};
  int number = 0;
  for (const auto& [printed, value, reason] : cases) {
    write_program(fmt::format("say{}", ++number), "#!/bin/sh\necho '" + printed + "'\n");
    const OwnProblem own(file(fmt::format("executable = './say{}'", number)));
    const double got = own.problem().evaluate(Vector{{0, 0}}).objective;
    EXPECT_TRUE(got == value || (std::isnan(got) && std::isnan(value))) << printed << ": " << got;
    EXPECT_THAT(reasons(own), HasSubstr(reason)) << printed;
    EXPECT_EQ(reasons(own).empty(), reason.empty()) << printed;
  }
}

TEST_F(OwnProblemTest, GoesOnToTheBitAfterItWasKilled) {
  const std::string plain_variables =
      "[[variable]]\nname = 'a'\nlower = -2\nupper = 2\n[[variable]]\nname = 'b'\nlower = "
      "-2\nupper = 2\n";
  const auto problem_in = [&](const fs::path& folder, bool noise) {
    fs::permissions(write_file(folder / "bowl",
                               "#!/bin/sh\necho >> calls\n"
                               "awk '{ OFMT = \"%.17g\"; print ($1-0.3)^2 + 2*($2+0.7)^4 }' $1\n"),
                    fs::perms::owner_all);
    return problem_file_from(
        fmt::format("name = 'p'\nnoise = {}\n[program]\nexecutable = './bowl'\n{}", noise,
                    plain_variables),
        folder / "p.toml");
  };
  const auto trace_of = [](const ProblemFile& file) {
    const OwnProblem own(file, "nlopt-nelder-mead");
    return run(own.problem(), solver_named("nlopt-nelder-mead"), {60}, 0).trace;
  };
  const auto calls_in = [](const fs::path& folder) {
    return lines_of(ricochet::text_of(folder / "calls")).size();
  };
  for (const bool noise : {false, true}) {
    SCOPED_TRACE(noise);
    const fs::path whole = folder_ / fmt::format("whole{}", noise),
                   broken = folder_ / fmt::format("broken{}", noise);
    const auto undisturbed = trace_of(problem_in(whole, noise));
    int kills = 0;
    for (int k = 0; k < 8; ++k) {
      const pid_t child = fork();
      if (child == 0) {
        trace_of(problem_in(broken, noise));
        _exit(0);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      kill(child, SIGKILL);
      int status = 0;
      waitpid(child, &status, 0);
      kills += WIFSIGNALED(status) ? 1 : 0;
    }
    EXPECT_GT(kills, 2);
    const auto resumed = trace_of(problem_in(broken, noise));
    ASSERT_EQ(resumed.size(), undisturbed.size());
    for (std::size_t i = 0; i < resumed.size(); ++i) {
      EXPECT_EQ(resumed[i].x, undisturbed[i].x);
      EXPECT_EQ(resumed[i].true_values.objective, undisturbed[i].true_values.objective);
    }
    // At most the one in flight is lost at each kill.
    EXPECT_LE(calls_in(broken), calls_in(whole) + static_cast<std::size_t>(kills));
  }
}

TEST_F(OwnProblemTest, KeepsEveryEvaluationOfANoisyPoint) {
  write_program("noisy", "#!/bin/sh\necho >> calls\necho $(wc -l < calls) 0 0 0\n");
  for (int round = 0; round < 2; ++round) {
    const OwnProblem own(file("executable = './noisy'", "noise = true"), "first");
    for (int k = 1; k <= 3; ++k) EXPECT_EQ(own.problem().evaluate(Vector{{0, 0}}).objective, k);
  }
  const OwnProblem again(file("executable = './noisy'", "noise = true"), "first");
  again.problem().evaluate(Vector{{0, 0}});
  EXPECT_EQ(true_values_at(again.problem(), Vector{{0, 0}}).objective, 1)
      << "the one that was told";
  const OwnProblem other(file("executable = './noisy'", "noise = true"), "second");
  EXPECT_EQ(other.problem().evaluate(Vector{{0, 0}}).objective, 4) << "of another run";
}

TEST_F(OwnProblemTest, MakesEvaluationsAgainIfAllHadFailed) {
  write_program("later", "#!/bin/sh\ntest -e ready && echo 5 0 0 0\n");
  const Vector x{{0, 0}};
  EXPECT_TRUE(
      std::isnan(OwnProblem(file("executable = './later'")).problem().evaluate(x).objective));
  write_file(folder_ / "ready", "");
  const OwnProblem own(file("executable = './later'"));
  EXPECT_TRUE(std::isnan(own.problem().evaluate(x).objective)) << "kept";
  EXPECT_EQ(own.store().forget_if_all_failed(), 1);
  EXPECT_EQ(own.problem().evaluate(x).objective, 5);
  EXPECT_EQ(own.store().forget_if_all_failed(), 0);
  EXPECT_EQ(own.problem().evaluate(x).objective, 5);
}

TEST_F(OwnProblemTest, RefusesFilesWithPlaceValueAndWhatIsAllowed) {
  write_program("it", "#!/bin/sh\n");
  const std::string program = "[program]\nexecutable = './it'\n";
  const std::string a = "[[variable]]\nname = 'a'\nlower = 0\nupper = 1\n";
  const auto read = [&](const std::string& text) {
    return OwnProblem(problem_file_from(text, folder_ / "p.toml"));
  };
  expect_refusals(
      read,
      {{"name = 'p'\n" + a, "program"},
       {"name = 'p'\n" + program, "variable"},
       {"name = 'a b'\n" + program + a, "name"},
       {"name = 'p'\nmood = 1\n" + program + a, "mood"},
       {"name = 'p'\ngoal = 'best'\n" + program + a, "\"minimise\" or \"maximise\""},
       {"name = 'p'\n[program]\ncommand = 'cat'\nlibrary = 'x.so'\n" + a, "one of command"},
       {"name = 'p'\n[program]\ncommand = 'cat'\ntold = true\n" + a, "one of command"},
       {"name = 'p'\n[program]\nexecutable = './none'\n" + a, "no such program"},
       {"name = 'p'\n[program]\nlibrary = 'none.so'\n" + a, "no such file"},
       {"name = 'p'\n" + program + "files = ['none']\n" + a, "no such file"},
       {"name = 'p'\n" + program + "derivatives = true\n" + a, "derivatives"},
       {"name = 'p'\n" + program + "seconds = 0\n" + a, "a finite number > 0"},
       {"name = 'p'\n" + program + "outputs = ['value']\n" + a, "no such output"},
       {"name = 'p'\n" + program + "outputs = ['ignored']\n" + a, "objective is missing"},
       {"name = 'p'\n" + program + a + a, "the name is taken"},
       {"name = 'p'\n" + program + a + "[[constraint]]\nname = 'objective'\n", "taken"},
       {"name = 'p'\n" + program + a + "[[constraint]]\nname = 'c'\nkind = 'soft'\n", "\"binary\""},
       {"name = 'p'\n" + program + a + "start = 2\n", "within 0..1"},
       {"name = 'p'\n" + program + a + "scale = 'logarithmic'\n", "> 0, as the scale"},
       {"name = 'p'\n" + program + "[[variable]]\nname = 'a'\nlower = 1\nupper = 0\n",
        "no less than lower"},
       {"name = 'p'\n" + program + "[[variable]]\nname = 'a'\nlower = 1\nupper = 1\n",
        "at least one variable"},
       {"name = 'p'\n" + program + "[[variable]]\nname = 'a'\nlower = 0\nupper = inf\n",
        "finite"}});
  write_file(folder_ / "p.evaluations", "something else");
  const OwnProblem unkept = read("name = 'p'\n" + program + a);
  EXPECT_THAT(complaint_of([&] { return unkept.store().failures(); }), HasSubstr("p.evaluations"));
}

TEST(ProblemFiles, HaveEveryKeyInTheirTemplateAndTheirPage) {
  static const std::regex word("[a-z_]+");
  const fs::path source = RICOCHET_SOURCE;
  const std::string page = ricochet::text_of(source / "docs/your-own-problem.md"),
                    form = ricochet::text_of(source / "src/app/problem_template.toml");
  const std::string name = "name = 'p'\n", program = name + "[program]\nexecutable = './it'\n",
                    variable = program + "[[variable]]\nname = 'a'\nlower = 0\nupper = 1\n";
  // Each text ends in the table that the unknown key is in; the least number of its keys.
  for (const auto& [text, least] :
       {std::pair(name, 9U), std::pair(program, 10U), std::pair(variable, 6U),
        std::pair(variable + "[[constraint]]\n", 2U)}) {
    const std::string said =
        complaint_of([text = text] { return problem_file_from(text + "qqqqqqqq = 1", "p.toml"); });
    const std::size_t list = said.find("allowed: ");
    ASSERT_NE(list, std::string::npos) << said;
    const std::string keys = said.substr(list + 9);
    std::size_t number = 0;
    for (std::sregex_iterator key(keys.begin(), keys.end(), word), end; key != end;
         ++key, ++number) {
      EXPECT_THAT(page, testing::ContainsRegex(fmt::format("`{0}`|\\[{0}\\]", key->str())));
      EXPECT_THAT(form, testing::ContainsRegex(fmt::format("[ \n]{0} =|\\[{0}\\]", key->str())));
    }
    EXPECT_GE(number, least) << said;
  }
}

TEST_F(OwnProblemTest, IsTheSameAfterItIsWrittenAndRead) {
  write_program("it", "#!/bin/sh\n");
  const ProblemFile whole = file(
      "executable = './it'\nseconds = 2.5\nmegabytes = 100\nfiles = ['it']\noutputs = ['disk', "
      "'side', 'line', 'ignored', 'objective']",
      "unit = 'kg'\ngoal = 'maximise'\nnoise = true\nbest_known = 3\ntolerance = 0.1");
  EXPECT_EQ(problem_file_from(text_of(whole), whole.path), whole);
}

}  // namespace
}  // namespace ricochet::own
