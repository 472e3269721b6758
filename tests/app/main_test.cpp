#include "tests/app/tool.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

/// What every command owes its user: help, streams, colours, names to complete.
namespace ricochet::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Main, TellsItsVersion) {
  EXPECT_THAT(out_of("--version"),
              AllOf(StartsWith("ricochet 0.2.0 (commit "), HasSubstr("Eigen 3"), HasSubstr("fmt "),
                    HasSubstr("CLI11 "), HasSubstr("NLopt ")));
}

TEST(Main, EchoesBadInputInOneShortLine) {
  const Outcome outcome = call("simulate --case \"$(printf 'C\\033[31m%0100000d')\"");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 5000U);
  EXPECT_THAT(outcome.err, HasSubstr("C\\x1b[31m000"));
}

TEST(Main, ReportsOutputThatIsLostWhereThereIsSome) {
  if (const auto reason = missing({"/dev/full"}); !reason.empty()) GTEST_SKIP() << reason;
  for (const std::string arguments :
       {"scene --case C1", "list problems", "list problems --format json", "simulate --case C1",
        "--version", "--help", "list --help"}) {
    for (const std::string output : {" >/dev/full", " >&-"}) {
      const Outcome outcome = call(arguments + output);
      EXPECT_EQ(outcome.exit_code, 1) << arguments << output;
      EXPECT_THAT(outcome.err, testing::MatchesRegex("ricochet: standard output: [^\n]*\n"))
          << arguments << output;
    }
  }
  EXPECT_EQ(call("list speeds >/dev/full").exit_code, 2);
}

constexpr const char* two_runs =
    "name = \"small\"\n[[part]]\nproblems = [\"classic-sphere-5\"]\n"
    "solvers = [\"random-search\"]\nbudgets = [20]\ninstances = 2\n";

/// Closed, or full: what is said there is lost, and the command does its work, whichever streams
/// are closed beside it.
TEST(Main, NeedsNoStandardError) {
  if (const auto reason = missing({"/dev/full", "/proc/self/exe"}); !reason.empty())
    GTEST_SKIP() << reason;
  write("plan.toml", two_runs);
  for (const std::string streams : {"2>&-", "2>/dev/full", "2>&- <&-", "2>/dev/full </dev/null"}) {
    std::filesystem::remove_all(here() / "made");
    EXPECT_THAT(out_of("run plan.toml --out made " + streams), HasSubstr("\ndigest ")) << streams;
    for (const std::string arguments :
         {"digest made", "threshold --case C1", "simulate --case C1",
          "solve mads count-C1 --budget 20", "verify --scenes 10", "report made"}) {
      out_of(arguments + " " + streams);
    }
    EXPECT_EQ(call("simulate --case C77 " + streams).exit_code, 2) << streams;
    EXPECT_EQ(call("simulate --case C1 >&- " + streams).exit_code, 1) << streams;
  }
}

/// What a command writes on a terminal of this environment, both streams.
std::string on_terminal(const std::string& environment, const std::string& arguments) {
  return call_in_shell(
             fmt::format("env -u NO_COLOR {} script -qec 'ricochet {}' /dev/null </dev/null",
                         environment, arguments))
      .out;
}

TEST(Main, SendsEscapesOnlyToATerminalThatTakesThem) {
  if (const auto reason = no_terminal(); !reason.empty()) GTEST_SKIP() << reason;
  const std::string wrong = "simulate --case C77";
  const std::string drawn = "solve random-search count-C1 --budget 300";
  EXPECT_THAT(on_terminal("TERM=xterm", wrong), HasSubstr("\x1b[31m"));
  EXPECT_THAT(on_terminal("TERM=xterm", drawn), HasSubstr("\x1b[K"));
  EXPECT_THAT(on_terminal("TERM=xterm NO_COLOR=1", wrong), Not(HasSubstr("\x1b")));
  for (const char* environment : {"TERM=dumb", "-u TERM", "TERM="}) {
    for (const std::string& command : {wrong, drawn, std::string("verify --scenes 3000")}) {
      const std::string shown = on_terminal(environment, command);
      EXPECT_NE(shown, "");
      EXPECT_THAT(shown, Not(HasSubstr("\x1b"))) << environment << command;
    }
  }
  EXPECT_THAT(on_terminal("TERM=dumb", wrong + " --color always"), HasSubstr("\x1b[31m"));
}

TEST(Main, ColoursErrorsWhereAsked) {
  EXPECT_THAT(call("simulate --case C77 --color always").err,
              StartsWith("\x1b[31mricochet:\x1b[m C77: "));
  EXPECT_THAT(call("simulate --case C77 --color never").err, StartsWith("ricochet: C77: "));
  EXPECT_THAT(call("calibrate --color always --interpretation sideways").err,
              HasSubstr("\x1b[31mricochet:\x1b[m --interpretation sideways: there is no such"))
      << "returned";
}

/// However small the stack is, a command works or says what it needs.
TEST(DailyUse, WorksOnASmallStackOrSaysWhatItNeeds) {
  for (const int kilobytes : {48, 64, 96, 512, 2048}) {
    for (const char* arguments : {"list problems", "threshold --case C1", "solve mads count-C1",
                                  "solve ipopt hs-71", "machine check /dev/null"}) {
      const Outcome outcome =
          call_in_shell(fmt::format("ulimit -s {}; ricochet {}", kilobytes, arguments));
      EXPECT_LE(outcome.exit_code, 2) << arguments << kilobytes << outcome.err;
      if (kilobytes < 1024 && outcome.exit_code != 0) {
        EXPECT_THAT(outcome.err, testing::AnyOf(HasSubstr("must be at least 1024, see ulimit -s"),
                                                HasSubstr("/dev/null")));
      }
    }
  }
}

TEST(Description, OfEveryCommandHasExamplesAndExitCodes) {
  if (const auto reason = no_other_programs(); !reason.empty()) GTEST_SKIP() << reason;
  for (const std::string command :
       {"machine",   "simulate",  "threshold", "regimes",    "identify",   "scene",     "list",
        "solve",     "evaluate",  "compare",   "plan",       "run",        "replay",    "merge",
        "digest",    "submit",    "export",    "report",     "site",       "reproduce", "calibrate",
        "surrogate", "fireworks", "verify",    "simulators", "best-values"}) {
    EXPECT_THAT(out_of(command + " --help"), AllOf(HasSubstr("Usage: ricochet " + command),
                                                   HasSubstr("Examples:\n  ricochet " + command),
                                                   HasSubstr("Exit codes: 0 done; 1 ")));
  }
}

}  // namespace
}  // namespace ricochet::cli
