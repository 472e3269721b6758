#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// What bash offers for the last of the words.
std::string completed_by_bash(const std::string& words, int last) {
  const auto folder = fresh_folder();
  const auto script = write(folder, "script", call("describe bash").out);
  write(folder, "machine one.toml", "");
  const int status =
      std::system(fmt::format("cd {} && bash -c 'source {}; COMP_WORDS=({}); COMP_CWORD={}; "
                              "_ricochet; printf \"%s,\" \"${{COMPREPLY[@]}}\"' >out 2>&1",
                              folder.string(), script.string(), words, last)
                      .c_str());
  EXPECT_EQ(status, 0);
  return read(folder / "out");
}

TEST(Description, IsCompletedByBash) {
  EXPECT_EQ(completed_by_bash("ricochet thr", 1), "threshold,");
  EXPECT_EQ(completed_by_bash("ricochet sit", 1), "site,");
  EXPECT_EQ(completed_by_bash("ricochet simulate --fo", 2), "--format,");
  EXPECT_EQ(completed_by_bash("ricochet threshold --pl", 2), "--plot,");
  EXPECT_EQ(completed_by_bash("ricochet threshold --plot m", 3), "machine one.toml,");
  EXPECT_EQ(completed_by_bash("ricochet simulate --format j", 3), "json,");
  EXPECT_EQ(completed_by_bash("ricochet calibrate --all", 2), "--all-interpretations,");
  EXPECT_EQ(completed_by_bash("ricochet list p", 2), "problems,");
  EXPECT_EQ(completed_by_bash("ricochet machine ch", 2), "check,");
  EXPECT_EQ(completed_by_bash("ricochet simulate --scene m", 3), "machine one.toml,");
  EXPECT_EQ(completed_by_bash("ricochet help thr", 2), "threshold,");
  EXPECT_EQ(completed_by_bash("ricochet hel", 1), "help,");
  EXPECT_EQ(completed_by_bash("ricochet machine check m", 3), "machine one.toml,");
  EXPECT_EQ(completed_by_bash("ricochet plan check d", 3), "default,");
  EXPECT_EQ(completed_by_bash("ricochet plan check n", 3), ",") << "nothing of the other parts";
  EXPECT_EQ(completed_by_bash("ricochet plan sample --sh", 3), "--share,");
}

TEST(Description, CompletesNamesOfProblemsSolversPlansAndCases) {
  EXPECT_EQ(completed_by_bash("ricochet solve random-sear", 2), "random-search,");
  EXPECT_EQ(completed_by_bash("ricochet solve nlopt-cobyla top-speed-C12", 3), "top-speed-C12,");
  EXPECT_EQ(completed_by_bash("ricochet evaluate hs-71", 2), "hs-71,");
  EXPECT_EQ(completed_by_bash("ricochet compare --problems top-speed-C12", 3), "top-speed-C12,");
  EXPECT_EQ(completed_by_bash("ricochet compare --solvers random-sear", 3), "random-search,");
  EXPECT_EQ(completed_by_bash("ricochet compare --solver ma", 3),
            "mads,mads-tuned,machine one.toml,");
  EXPECT_EQ(completed_by_bash("ricochet list problems --family top-s", 4), "top-speed,");
  EXPECT_EQ(completed_by_bash("ricochet list problems --solver-accepts random-sear", 4),
            "random-search,");
  EXPECT_EQ(completed_by_bash("ricochet best-values --problems hs-71", 3), "hs-71,");
  EXPECT_EQ(completed_by_bash("ricochet run def", 2), "default,");
  EXPECT_EQ(completed_by_bash("ricochet plan check m", 3), "machine one.toml,");
  EXPECT_EQ(completed_by_bash("ricochet threshold --case C12", 3), "C12,");
  EXPECT_THAT(call("describe zsh").out,
              AllOf(HasSubstr(":value:_ricochet_or_file "), HasSubstr(" nlopt-cobyla "),
                    HasSubstr(" top-speed-C12 ")));
  EXPECT_THAT(call("describe fish").out,
              AllOf(HasSubstr("from run' -F -a 'quick default studies reference full'"),
                    HasSubstr("-l solver-accepts -r -F -a '")));
  EXPECT_THAT(call("describe man").out, testing::Not(HasSubstr("top\\-speed\\-C12")));
}

TEST(Description, HasEveryCommandForTheOtherShellsAndTheManual) {
  EXPECT_THAT(call("describe zsh").out,
              AllOf(HasSubstr("#compdef ricochet"), HasSubstr("'calibrate:Fit the unknown"),
                    HasSubstr("'--format[What to print: text or json]:value:(text json)'"),
                    HasSubstr("'--all-interpretations[")));
  EXPECT_THAT(call("describe fish").out,
              AllOf(HasSubstr("-n __fish_use_subcommand -a calibrate"),
                    HasSubstr("'__fish_seen_subcommand_from calibrate' -l all-interpretations"),
                    HasSubstr("-l format -x -a 'text json'")));
  EXPECT_THAT(call("describe man").out,
              AllOf(HasSubstr(".TH RICOCHET 1"), HasSubstr(".SS best\\-values"),
                    HasSubstr("\\fB\\-\\-omega\\fR \\fIFLOAT\\fR"),
                    HasSubstr("\\-\\-all\\-interpretations"),
                    HasSubstr("What to print: text or json.\nOne of text, json."),
                    HasSubstr(".SH EXIT STATUS")));
}

TEST(Description, OfEveryCommandHasExamplesAndExitCodes) {
  for (const char* command : {"reproduce", "simulate", "threshold", "scene", "evaluate", "export",
                              "solve", "compare", "list", "report", "machine", "calibrate",
                              "simulators", "surrogate", "fireworks", "verify", "best-values"}) {
    EXPECT_THAT(call(std::string(command) + " --help").out,
                AllOf(HasSubstr(std::string("Usage: ricochet ") + command),
                      HasSubstr(std::string("Examples:\n  ricochet ") + command),
                      HasSubstr("Exit codes: 0 done; 1 ")))
        << command;
  }
}

}  // namespace
}  // namespace ricochet::cli
