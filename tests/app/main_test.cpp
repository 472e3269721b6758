#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Main, NamesEveryCommandInItsHelp) {
  const Outcome help = call("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command : {"reproduce", "simulators", "simulate", "threshold", "machine",
                              "scene", "evaluate", "list"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    EXPECT_EQ(call(std::string(command) + " --help").exit_code, 0) << command;
  }
  EXPECT_THAT(help.out, HasSubstr("bench"));  // whose program need not be there
}

TEST(Main, GroupsTheCommandsInItsHelp) {
  const std::string help = call("--help").out;
  std::size_t last = 0;
  for (const char* line : {"machine:\n  machine ",
                           "  simulate ",
                           "  threshold ",
                           "  scene ",
                           "solve:\n  list ",
                           "  solve ",
                           "  evaluate ",
                           "  compare ",
                           "campaign:\n  plan ",
                           "  run ",
                           "  replay ",
                           "  merge ",
                           "  digest ",
                           "  export ",
                           "  report ",
                           "paper:\n  reproduce ",
                           "  calibrate ",
                           "suite:\n  verify ",
                           "  best-values ",
                           "  bench "}) {
    const std::size_t at = help.find(std::string("\n") + line, last);
    ASSERT_NE(at, std::string::npos) << line << help;
    last = at;
  }
}

TEST(Main, HelpsWithAWordToo) {
  EXPECT_EQ(call("help").out, call("--help").out);
  EXPECT_EQ(call("help simulate").out, call("simulate --help").out);
  EXPECT_EQ(call("help machine check").out, call("machine check --help").out);
  EXPECT_EQ(call("help calibrate").out, call("calibrate --help").out);
  expect_refusal("help simulat", "simulat is no command; did you mean simulate or simulators?");
}

TEST(Main, TellsItsVersion) {
  const std::string text = call("--version").out;
  EXPECT_THAT(text, testing::StartsWith("ricochet 0.2.0 (commit "));
  for (const char* library : {"Eigen 3", "fmt ", "CLI11 ", "NLopt "}) {
    EXPECT_THAT(text, HasSubstr(library));
  }
}

TEST(Main, RefusesWhatItDoesNotKnow) {
  expect_refusal("", "ommand");
  expect_refusal("hammer", "hammer is no command; allowed: machine, simulate");
  expect_refusal("simulate --case C1 --speed 3", "--speed");
  expect_refusal("simulate --case C1 --omega fast", "--omega");
  expect_refusal("threshold --case C1 --format xml", "--format");
}

TEST(Main, SaysWhatMayHaveBeenMeant) {
  expect_refusal("simulat", "simulat is no command; did you mean simulate or simulators?");
  expect_refusal("--versoin", "ricochet: --versoin is not expected; did you mean --version?");
  expect_refusal("simulate --case C1 --omga 3", "did you mean --omega?");
  expect_refusal("simulate --case C1 --omega=3 --plt=x", "did you mean --plot?");
}

TEST(Main, NamesTheCommandWhoseHelpSaysMore) {
  expect_refusal("solve bisection", "solve: problem is required, as in: ricochet solve ");
  expect_refusal("machine",
                 "as in: ricochet machine new > machine.toml; see ricochet machine --help");
  expect_refusal("plan check",
                 "as in: ricochet plan check plan.toml; see ricochet plan check --help");
  expect_refusal("verify --scenes x", "see ricochet verify --help");
  expect_refusal("hammer", "see ricochet --help");
  expect_refusal("plan check quik", "quik: there is no such file; did you mean quick?");
  EXPECT_THAT(call("plan --help").out, HasSubstr("\nCommands:\n  new "));
  EXPECT_THAT(call("solve --help").out, HasSubstr("--format FORMAT:{text,json}=text"));
}

TEST(Main, RefusesEmptyValues) {
  for (const char* arguments : {"simulate --case C1 --omega ''", "simulate --case C1 --csv ''",
                                "reproduce --out ''", "simulate --scene ''", "report ''"}) {
    expect_refusal(arguments, "must not be empty");
  }
}

TEST(Main, EchoesBadInputInOneShortLine) {
  const Outcome outcome = call("simulate --case \"$(printf 'C\\033[31m%0100000d')\"");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 5000U);
  EXPECT_THAT(outcome.err, HasSubstr("C\\x1b[31m000"));
}

TEST(Main, ReportsOutputThatIsLost) {
  for (const char* arguments : {"scene --case C1", "list problems", "list problems --format json",
                                "simulate --case C1", "--version", "--help", "list --help"}) {
    for (const char* output : {">/dev/full", ">&-"}) {
      const Outcome outcome = call_with_output(arguments, output);
      EXPECT_EQ(outcome.exit_code, 1) << arguments << output;
      EXPECT_THAT(outcome.err, testing::StartsWith("ricochet: standard output: ")) << arguments;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
  }
}

TEST(Main, NeedsNoOutputWhereThereIsNone) {
  EXPECT_EQ(call_with_output("list speeds", ">/dev/full").exit_code, 2);
}

/// As spreadsheets and editors of Windows write it before a text.
TEST(Main, SkipsAByteOrderMarkInWhateverTextItReads) {
  const auto folder = fresh_folder();
  const std::string mark = "\xef\xbb\xbf";
  const auto marked = [&](const std::string& name, const std::string& command) {
    const Outcome text = call(command);
    EXPECT_EQ(text.exit_code, 0) << command;
    return write(folder, name, mark + text.out).string();
  };
  const std::string machine = marked("machine.toml", "machine new");
  const std::string plan = marked("plan.toml", "plan new");
  const auto points = write(folder, "points", mark + R"({"x": [0.5, 0.25]})" + "\n").string();
  for (const std::string& arguments :
       {"machine check " + machine, "simulate --scene " + machine, "plan check " + plan,
        "evaluate classic-rosenbrock-2 < " + points}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    EXPECT_THAT(outcome.out, Not(HasSubstr("error"))) << arguments;
  }
}

/// Closed, or full: what is said there is lost, and the command does its work, whichever streams
/// are closed beside it.
TEST(Main, NeedsNoStandardError) {
  const auto folder = fresh_folder();
  const auto plan = write(folder, "plan.toml",
                          "name = \"small\"\n[[part]]\nproblems = [\"classic-sphere-5\"]\n"
                          "solvers = [\"random-search\"]\nbudgets = [20]\ninstances = 2\n");
  int folders = 0;
  for (const char* streams : {"2>&-", "2>/dev/full", "2>&- <&-", "2>/dev/full </dev/null"}) {
    const std::string out = (folder / std::to_string(folders++)).string();
    const Outcome ran = call("run " + plan.string() + " --out " + out + " " + streams);
    EXPECT_EQ(ran.exit_code, 0) << streams;
    EXPECT_THAT(ran.out, HasSubstr("\ndigest ")) << streams;
    EXPECT_EQ(call("digest " + out + "/runs.sqlite").exit_code, 0) << streams;
    for (const char* arguments :
         {"threshold --case C1", "simulate --case C1", "solve mads count-C1 --budget 20",
          "verify --scenes 10", "report "}) {
      const bool draws = arguments == std::string("report ");
      const Outcome outcome = call(arguments + (draws ? out : "") + " " + streams);
      EXPECT_EQ(outcome.exit_code, 0) << arguments << streams;
    }
    EXPECT_EQ(call(std::string("simulate --case C77 ") + streams).exit_code, 2) << streams;
    EXPECT_EQ(call(std::string("simulate --case C1 >&- ") + streams).exit_code, 1) << streams;
  }
}

/// What a command writes on a terminal of this environment, both streams.
std::string on_terminal(const std::string& environment, const std::string& arguments) {
  const auto folder = fresh_folder();
  std::system(
      fmt::format("cd {3} && env -u NO_COLOR {0} script -qec '{1} {2}' /dev/null </dev/null >shown",
                  environment, RICOCHET_PROGRAM, arguments, folder.string())
          .c_str());
  return read(folder / "shown");
}

TEST(Main, SendsEscapesOnlyToATerminalThatTakesThem) {
  const std::string wrong = "simulate --case C77";
  const std::string drawn = "solve random-search count-C1 --budget 300";
  EXPECT_THAT(on_terminal("TERM=xterm", wrong), HasSubstr("\x1b[31m"));
  EXPECT_THAT(on_terminal("TERM=xterm", drawn), HasSubstr("\x1b[K"));
  EXPECT_THAT(on_terminal("TERM=xterm NO_COLOR=1", wrong), testing::Not(HasSubstr("\x1b")));
  for (const char* environment : {"TERM=dumb", "-u TERM", "TERM="}) {
    for (const std::string& command : {wrong, drawn, std::string("verify --scenes 3000")}) {
      const std::string shown = on_terminal(environment, command);
      EXPECT_NE(shown, "");
      EXPECT_THAT(shown, testing::Not(HasSubstr("\x1b"))) << environment << command;
    }
  }
  EXPECT_THAT(on_terminal("TERM=dumb", wrong + " --color always"), HasSubstr("\x1b[31m"));
}

TEST(Main, ColoursErrorsWhereAsked) {
  const std::string wrong = "simulate --case C77 --color ";
  EXPECT_THAT(call(wrong + "always").err, HasSubstr("\x1b[31mricochet:\x1b[m C77: "));
  EXPECT_THAT(call(wrong + "never").err, testing::StartsWith("ricochet: C77: "));
  EXPECT_THAT(call("calibrate --color always --interpretation sideways").err,
              HasSubstr("\x1b[31mricochet:\x1b[m --interpretation"))
      << "returned";
  expect_refusal("simulate --case C77", "C77");
}

}  // namespace
}  // namespace ricochet::cli
