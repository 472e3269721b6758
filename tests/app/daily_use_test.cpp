#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/app/tool.h"

/// What a command owes its user: what was probably meant, and what is not as it seems.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* one_run_plan =
    "name = \"small\"\n[[part]]\nproblems = [\"classic-sphere-5\"]\n"
    "solvers = [\"random-search\"]\nbudgets = [20]\ninstances = 2\n";

TEST(DailyUse, SaysWhatWasProbablyMeant) {
  const fs::path folder = fresh_folder();
  const std::string machine = write(folder, "machine.toml", call("machine new").out).string();
  const std::string knocks = write(folder, "knocks.csv", "time\n0.5\n").string();
  struct Slip {
    std::string arguments, hint;
  };
  for (const auto& [arguments, hint] : std::vector<Slip>{
           {"lst problems", "lst is no command; did you mean list?; see ricochet --help"},
           {"thresold --case C1", "did you mean threshold?"},
           {"chek machine.toml", "chek is no command"},
           {"simulate " + machine, "give it as --scene " + machine},
           {"threshold " + machine, "give it as --scene"},
           {"regimes " + machine, "give it as --scene"},
           {"scene C1", "C1: give it as --case C1"},
           {"regimes c12", "c12: give it as --case C12"},
           {"simulate --case C1 impact", "impact: give it as --fidelity impact"},
           {"list solver", "solver: did you mean solvers?"},
           {"list problems --format jsn", "--format jsn: did you mean json?"},
           {"solve mine.so", "problem is required, as in: ricochet solve "},
           {"machine check", "file is required, as in: ricochet machine check machine.toml"},
           {"merge all.sqlite", "as in: ricochet merge runs.sqlite"},
           {"solve count-C1 mads", "the solver comes first: ricochet solve mads count-C1"},
           {"solve hs-71 nlopt-slsqp", "ricochet solve nlopt-slsqp hs-71"},
           {"replay 17 " + knocks, "the store comes first"},
           {fmt::format("identify {} --scene {}", machine, knocks), "the knocks come first"},
           {"simulate --case C1 --omega 60rpm",
            "--omega 60rpm: must be a number, without a unit, in rad/s: 6.28319"},
           {"threshold --case C1 --fastest '90 rpm'", "in rad/s: 9.42478"},
           {"threshold --case C1 --seconds 5s", "--seconds 5s: must be a number, without a unit"},
           {"solve mads hs-71 --budget many", "--budget many: must be a number"},
           {"report " + machine, "must be a folder"}}) {
    expect_refusal(arguments, hint);
  }
}

TEST(DailyUse, TakesTheUsualOptionsInEveryPartOfACommand) {
  const fs::path folder = fresh_folder();
  const std::string machine = write(folder, "machine.toml", call("machine new").out).string();
  const std::string plan = write(folder, "plan.toml", one_run_plan).string();
  for (const std::string& call_ :
       {"machine check " + machine, "plan check " + plan, "plan slurm " + plan,
        std::string("machine new"), std::string("plan new")}) {
    const Outcome plain = call(call_);
    for (const char* option : {" --quiet", " --color never", " --color always --quiet"}) {
      const Outcome outcome = call(call_ + option);
      EXPECT_EQ(outcome.exit_code, 0) << call_ << option << outcome.err;
      EXPECT_EQ(outcome.out, plain.out) << call_ << option;
    }
  }
}

/// Every command that reads a store takes the included archive by its name, and a campaign's
/// folder.
TEST(DailyUse, ReadsStoresByFolderAndName) {
  const fs::path folder = fresh_folder();
  const std::string plan = write(folder, "plan.toml", one_run_plan).string();
  const std::string made = (folder / "made").string();
  ASSERT_EQ(call(fmt::format("run {} --out {}", plan, made)).exit_code, 0);
  const std::string out = folder.string();
  for (const std::string& arguments :
       {"digest " + made, fmt::format("export {} --format csv --out {}/csv", made, out),
        fmt::format("compare --stores {0} {0}", made), fmt::format("replay {} 1", made),
        fmt::format("merge {}/all.sqlite {}", out, made),
        fmt::format("submit {} --solvers random-search --out {}/a", made, out),
        std::string("digest archive")}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
  }
  // Found, but not written: the folder is not empty, the file is there.
  expect_refusal(fmt::format("export archive --format csv --out {}", out), "new or empty");
  expect_refusal(fmt::format("merge {}/all.sqlite nothing archive", out),
                 "nothing: cannot be read");
}

TEST(DailyUse, SaysThatThereIsNothingToResume) {
  const fs::path folder = fresh_folder();
  const std::string plan = write(folder, "plan.toml", one_run_plan).string();
  const std::string run = fmt::format("run {} --out {}/made", plan, folder.string());
  const Outcome first = call(run + " --resume");
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_THAT(first.err, HasSubstr("made/runs.sqlite: is not there: there is nothing to resume"));
  EXPECT_THAT(call(run + " --resume").err, Not(HasSubstr("nothing to resume")));
  EXPECT_THAT(call(fmt::format("run {} --out {}/other", plan, folder.string())).err,
              Not(HasSubstr("nothing to resume")));
}

TEST(DailyUse, NoticesThatItsFolderIsGone) {
  const fs::path folder = fresh_folder();
  const std::string plan =
      write(folder, "plan.toml",
            "name = \"long\"\n[[part]]\nproblems = [\"hs-*\", \"count-*\"]\n"
            "solvers = [\"random-search\", \"nlopt-cobyla\"]\nbudgets = [5000]\n"
            "instances = 15\n")
          .string();
  const fs::path made = folder / "made";
  for (const bool moved : {false, true}) {
    std::thread removing([&] {
      while (!fs::exists(made / "runs.sqlite")) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::seconds(1));
      if (moved) {
        fs::rename(made, folder / "elsewhere");
      } else {
        fs::remove_all(made);
      }
    });
    const Outcome outcome =
        call_interrupted("KILL", fmt::format("run {} --out {}", plan, made.string()), 30);
    removing.join();
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("made/runs.sqlite: was removed while runs were added"));
    EXPECT_FALSE(fs::exists(made / "index.html"));
  }
}

TEST(DailyUse, ChecksAMachineAsJson) {
  const std::string machine =
      write(fresh_folder(), "machine.toml", call("machine new").out).string();
  const Outcome outcome = call("machine check " + machine +
                               " --set 'mass={value = \"900 g\", plus_minus = \"50 g\"}' "
                               "--set wall_upper=inf --format json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["machine"]["scene"]["mass"], 0.9);
  EXPECT_EQ(json["machine"]["scene"]["friction"], 0.2);
  EXPECT_TRUE(json["machine"].contains("window"));
  ASSERT_EQ(json["uncertain"].size(), 1U);
  EXPECT_EQ(json["uncertain"][0]["key"], "scene.mass");
  EXPECT_EQ(json["uncertain"][0]["plus_minus"], 0.05);
  EXPECT_TRUE(json["doubts"].is_array());
}

/// Numbers that once came out as -nan, or crashed.
TEST(DailyUse, ShowsNumbers) {
  const fs::path folder = fresh_folder();
  const std::string machine = write(folder, "machine.toml", call("machine new").out).string();
  for (const char* setting : {"restitution_upper=0", "restitution_lower=0", "friction=0",
                              "restitution_lower=1", "normal_force=0"}) {
    const Outcome outcome =
        call(fmt::format("threshold --scene {} --set {} --seconds 60", machine, setting));
    EXPECT_THAT(outcome.out, Not(HasSubstr("nan"))) << setting;
    EXPECT_THAT(outcome.out, HasSubstr("restitution ")) << setting;
  }
}

/// However small the stack is, a command works or says what it needs.
TEST(DailyUse, WorksOnASmallStackOrSaysWhatItNeeds) {
  for (const int kilobytes : {48, 64, 96, 512, 2048}) {
    for (const char* arguments : {"list problems", "threshold --case C1", "solve mads count-C1",
                                  "solve ipopt hs-71", "machine check /dev/null"}) {
      const Outcome outcome =
          call_in_shell(fmt::format("ulimit -s {}; {} {}", kilobytes, RICOCHET_PROGRAM, arguments));
      EXPECT_LE(outcome.exit_code, 2) << arguments << kilobytes << outcome.err;
      if (kilobytes < 1024 && outcome.exit_code != 0) {
        EXPECT_THAT(outcome.err, testing::AnyOf(HasSubstr("must be at least 1024, see ulimit -s"),
                                                HasSubstr("/dev/null")));
      }
    }
  }
}

}  // namespace
}  // namespace ricochet::cli
