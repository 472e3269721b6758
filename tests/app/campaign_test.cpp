#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "src/core/files.h"
#include "src/report/json.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

using report::Json;

/// Some hundred runs, of a solver that repeats itself and of two that draw; half a second.
constexpr auto small_plan = R"(name = "small"
[limits]
seconds = 20
[[part]]
problems = ["count-C4", "hs-71"]
solvers = ["random-search", "nlopt-cobyla", "nlopt-slsqp"]
perturbations = ["plain", "noisy"]
gradient_prices = ["n", "measured"]
budgets = [20, 100]
instances = 3
)";

class CampaignCommands : public testing::Test {
 protected:
  /// The call's outcome, which must be a success.
  static std::string out_of(const std::string& arguments) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    return outcome.out;
  }

  std::string run(const std::string& out, const std::string& rest = "") const {
    return out_of(command(out, rest));
  }

  std::string command(const std::string& out, const std::string& rest = "") const {
    return fmt::format("run {} --out {} {}", plan_, (folder_ / out).string(), rest);
  }

  std::string store(const std::string& out) const {
    return (folder_ / out / "runs.sqlite").string();
  }

  /// The store's file and what lies beside it under its name.
  std::vector<std::string> files_of_store(const std::string& out) const {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder_ / out)) {
      const std::string name = file.path().filename();
      if (name.starts_with("runs.sqlite")) names.push_back(name);
    }
    return names;
  }

  /// What digest says once the processes that made runs have noticed that the program was killed.
  Outcome digest_after_kill(const std::string& out) const {
    Outcome outcome = call("digest " + store(out));
    for (int k = 0; k < 100 && outcome.err.find("is adding runs") != std::string::npos; ++k) {
      static_cast<void>(std::system("sleep 0.1"));
      outcome = call("digest " + store(out));
    }
    return outcome;
  }

  std::string digest(const std::string& out) const { return out_of("digest " + store(out)); }

  std::filesystem::path folder_ = fresh_folder();
  std::string plan_ = write(folder_, "plan.toml", small_plan).string();
};

TEST_F(CampaignCommands, PrintAPlanThatCanBeRead) {
  const auto plan = write(folder_, "new.toml", out_of("plan new"));
  const Json size = Json::parse(out_of("plan check --format json " + plan.string()));
  EXPECT_GT(size["runs"], 100);
  EXPECT_GT(size["seconds"], 0);
}

TEST_F(CampaignCommands, DrawAReportOfAFamilyThatSeveralPartsAskOf) {
  std::string parts;
  for (const int variables : {2, 4, 4}) {
    parts += fmt::format(
        "[[part]]\nproblems = \"profile-count-{}-C1\"\nsolvers = [\"random-search\", \"bbfwa\"]\n"
        "budgets = [{}]\ninstances = 1\n",
        variables, parts.size() + 10);
  }
  write(folder_, "plan.toml", parts + "name = \"again\"\n");
  run("one");
  for (const char* family : {"profile-count", "profile-count-part-2", "profile-count-again"}) {
    EXPECT_THAT(read(folder_ / "one" / "profile-count" / "index.html"),
                HasSubstr(fmt::format("<div class=\"choice\" id=\"{}\"", family)));
  }
}

TEST_F(CampaignCommands, SayNothingOfTheirProgressWhereTheyAreToBeQuiet) {
  EXPECT_THAT(call(command("loud")).err, HasSubstr("3 solvers on 2 problems"));
  EXPECT_EQ(call(command("quiet", "--quiet")).err, "");
  EXPECT_EQ(call(command("quiet", "--quiet --resume")).err, "");
}

TEST_F(CampaignCommands, SayHowManyRunsThereAreAndMakeSoMany) {
  const Json size = Json::parse(out_of("plan check --format json " + plan_));
  const std::string runs = std::to_string(size["runs"].get<int>());
  EXPECT_THAT(out_of("plan check " + plan_), HasSubstr(runs + " runs of 3 solvers on 2 problems"));
  EXPECT_THAT(run("one"), HasSubstr(runs + " runs: " + store("one")));
  EXPECT_EQ(size["cells"].get<int>() * 3, size["runs"].get<int>()) << "instances";
}

TEST_F(CampaignCommands, CountOneOfAKindAsOne) {
  write(folder_, "one.toml",
        "[[part]]\nproblems = \"count-C1\"\nsolvers = \"scan\"\nformulations = \"count\"\n"
        "budgets = [10]\ninstances = 1\n");
  EXPECT_THAT(out_of("plan check " + (folder_ / "one.toml").string()),
              HasSubstr("1 run of 1 solver on 1 problem, "));
}

TEST_F(CampaignCommands, SayHowLongTheWholeCommandTook) {
  const auto start = std::chrono::steady_clock::now();
  const std::string said = run("one");
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const std::size_t place = said.find("It took ");
  ASSERT_NE(place, std::string::npos) << said;
  const double told = std::atof(said.c_str() + place + 8);
  EXPECT_LT(told, elapsed.count() + 0.1);
  EXPECT_GT(told, 0.7 * elapsed.count() - 0.3) << "all but the start of the program";
}

TEST_F(CampaignCommands, GiveTheSameDigestHoweverTheRunsAreMade) {
  const std::string said = run("one", "--jobs 1");
  const std::string whole = digest("one");
  EXPECT_THAT(said, EndsWith("digest " + whole));
  EXPECT_EQ(whole.size(), 17U);
  run("two", "--jobs 2");
  EXPECT_EQ(digest("two"), whole);
  run("first", "--shard 1/2");
  run("second", "--shard 2/2");
  EXPECT_NE(digest("first"), whole);
  EXPECT_THAT(out_of(fmt::format("merge {}/runs.sqlite {} {}", folder_.string(), store("second"),
                                 store("first"))),
              EndsWith("digest " + whole));
  EXPECT_EQ(out_of(fmt::format("digest {}/runs.sqlite", folder_.string())), whole);
  run("first", "--shard 2/2 --resume");
  EXPECT_EQ(digest("first"), whole);
}

TEST_F(CampaignCommands, ReportOnAFamilyThatTwoPartsAskFor) {
  const auto plan = write(folder_, "two.toml",
                          "[[part]]\nproblems = \"count-C4\"\nsolvers = \"random-search\"\n"
                          "budgets = 5\ninstances = 2\n"
                          "[[part]]\nproblems = \"count-C1\"\nsolvers = \"random-search\"\n"
                          "budgets = 7\ninstances = 2\n");
  const std::string said =
      out_of(fmt::format("run {} --out {}", plan.string(), (folder_ / "two").string()));
  EXPECT_THAT(said, testing::ContainsRegex("\ncount +5 "));
  EXPECT_THAT(said, testing::ContainsRegex("\ncount-part-2 +7 "));
}

TEST_F(CampaignCommands, TellASolverWithOptionsOfItsOwn) {
  const std::string text =
      "[[solver]]\nname = \"bbfwa-40\"\nof = \"bbfwa\"\noptions = { sparks = 40 }\n"
      "[[part]]\nproblems = \"count-C4\"\nsolvers = \"bbfwa*\"\nbudgets = 50\ninstances = 2\n";
  const auto plan = write(folder_, "options.toml", text);
  EXPECT_THAT(out_of("plan check " + plan.string()),
              testing::AllOf(
                  HasSubstr("bbfwa-40: bbfwa with "),
                  testing::ContainsRegex("\nsparks +40 +300 +a whole number from 1 to 1000000\n"),
                  testing::ContainsRegex("\ngrowth +1.2 +a number from 1 to 1000\n")));
  out_of(fmt::format("run {} --out {}", plan.string(), (folder_ / "options").string()));
  EXPECT_THAT(read(folder_ / "options/solvers/index.html"), HasSubstr("sparks 40"));
  for (const int number : {1, 2, 3, 4}) {
    out_of(fmt::format("replay {} {}", store("options"), number));
  }
  const auto bad = write(folder_, "bad.toml",
                         "[[solver]]\nname = \"s\"\nof = \"scan\"\n"
                         "options = { sparks = 40 }\n" +
                             text);
  expect_refusal("plan check " + bad.string(), "solver s: scan: no such solver has options");
}

TEST_F(CampaignCommands, NeedFewOpenFilesAndSayWhenThereAreFewer) {
  const auto with = [this](int files) {
    const auto script = write(folder_, "script",
                              fmt::format("ulimit -n {}\nexec {} {}\n", files, RICOCHET_PROGRAM,
                                          command("few", "--quiet --jobs 1")));
    return call("--version >/dev/null; bash " + script.string());
  };
  const Outcome few = with(12);
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_THAT(few.err, HasSubstr("ricochet: too many open files: the limit is 12; raise it "
                                 "with ulimit -n "));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "few"));
  const Outcome enough = with(40);
  EXPECT_EQ(enough.exit_code, 0) << enough.err;
  run("usual");
  EXPECT_EQ(out_of("digest " + store("few")), out_of("digest " + store("usual")));
}

TEST_F(CampaignCommands, GoOnWhereTheyWereInterrupted) {
  run("whole");
  for (const std::string signal : {"INT", "KILL"}) {
    int interruptions = 0;
    for (int k = 1; k <= 20 && interruptions < 3; ++k) {
      const std::string call = fmt::format("timeout --signal={} {} {} {}", signal, 0.05 * k * k,
                                           RICOCHET_PROGRAM, command(signal, "--resume --quiet"));
      const int status = std::system((call + " >/dev/null 2>&1").c_str());
      if (status == 0) break;
      if (!std::filesystem::exists(store(signal))) continue;
      ++interruptions;
      if (signal == "KILL") digest_after_kill(signal);
      EXPECT_EQ(files_of_store(signal), std::vector<std::string>{"runs.sqlite"}) << signal;
    }
    EXPECT_GT(interruptions, 0) << signal;
    run(signal, "--resume");
    EXPECT_EQ(digest(signal), digest("whole")) << signal;
  }
}

TEST_F(CampaignCommands, WarnOfRunsThatMayBeMissing) {
  const auto plan = write(folder_, "long.toml",
                          "[[part]]\nproblems = \"count-C4\"\nsolvers = \"random-search\"\n"
                          "budgets = 100\ninstances = 100000");
  call_interrupted(
      "KILL", fmt::format("run {} --out {} --quiet", plan.string(), (folder_ / "long").string()),
      3);
  std::filesystem::create_directory(folder_ / "copy\x1b[31m");
  std::filesystem::copy(store("long"), store("copy\x1b[31m"));
  const std::string copy = fmt::format("'{}'", store("copy\x1b[31m"));
  for (const std::string& command :
       {"digest " + copy, fmt::format("merge {}/merged.sqlite {}", folder_.string(), copy),
        fmt::format("export {} --format csv --out {}/tables", copy, folder_.string()),
        fmt::format("replay {} 1", copy)}) {
    const std::string err = call(command).err;
    EXPECT_THAT(err, HasSubstr("runs may be missing")) << command;
    EXPECT_THAT(err, HasSubstr("copy\\x1b[31m/")) << command;
    EXPECT_THAT(err, Not(HasSubstr("\x1b"))) << command;
  }
  const std::string err = digest_after_kill("long").err;
  EXPECT_THAT(err, Not(HasSubstr("runs may be missing")));
  EXPECT_THAT(err, HasSubstr(" of 200000 planned runs are present, "));
  EXPECT_EQ(files_of_store("long"), std::vector<std::string>{"runs.sqlite"});
}

TEST_F(CampaignCommands, NameFilesSafelyForATerminal) {
  const auto safe = [](const std::string& arguments) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("odd\\x1b[31m")) << arguments;
    EXPECT_THAT(outcome.out, Not(HasSubstr("\x1b"))) << arguments;
  };
  const std::string out = (folder_ / "odd\x1b[31m").string();
  safe(fmt::format("run {} --out '{}'", plan_, out));
  safe(fmt::format("report '{}'", out));
  safe(fmt::format("merge '{0}.sqlite' '{0}/runs.sqlite'", out));
  safe(fmt::format("export '{0}/runs.sqlite' --format csv --out '{0}/tables'", out));
}

TEST_F(CampaignCommands, SayHowToGoOn) {
  const auto plan = write(folder_, "long.toml",
                          "[[part]]\nproblems = \"count-C4\"\nsolvers = \"random-search\"\n"
                          "budgets = 1000\ninstances = 10000");
  const Outcome outcome = call_interrupted(
      "INT", fmt::format("run {} --out {} --quiet", plan.string(), (folder_ / "long").string()), 2);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              EndsWith("ricochet: interrupted; finished runs are kept: --resume goes on\n"));
}

TEST_F(CampaignCommands, SayThatTheSameComparisonGoesOn) {
  const Outcome outcome =
      call_interrupted("INT",
                       fmt::format("compare --problems hs-71 --solvers random-search --budget 1000 "
                                   "--instances 10000 --quiet --out {}",
                                   (folder_ / "long").string()),
                       2);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(
      outcome.err,
      EndsWith("ricochet: interrupted; finished runs are kept: the same command goes on\n"));
}

TEST_F(CampaignCommands, MakeARunAgainToTheLastBit) {
  run("one");
  for (const int number : {1, 17, 50}) {
    const Json again =
        Json::parse(out_of(fmt::format("replay {} {} --format json", store("one"), number)));
    EXPECT_EQ(again["same"], true) << again;
    EXPECT_EQ(again["run"], number);
    const std::string key =
        fmt::format("{}/{}/{}/{}/{}/{}/{}/{}", again["problem"].get<std::string>(),
                    again["formulation"].get<std::string>(),
                    again["perturbation"].get<std::string>(), again["solver"].get<std::string>(),
                    again["budget"].get<int>(), again["gradient_price"].get<std::string>(),
                    again["instance"].get<int>(), again["seed"].get<int>());
    EXPECT_EQ(Json::parse(out_of(fmt::format("replay {} {} --format json", store("one"), key))),
              again);
  }
  expect_refusal("replay " + store("one") + " a/b/c/d/10/n/1/0", "the campaign has no problem a");
  expect_refusal("replay " + store("one") + " first", "run first: must be a number, or PROBLEM/");
  EXPECT_THAT(out_of("replay " + store("one") + " 3"), EndsWith("The same, to the last bit.\n"));
  expect_refusal("replay " + store("one") + " 0", "there is no run 0");
  expect_refusal("replay " + store("one") + " 100000", "there is no run 100000");
}

TEST_F(CampaignCommands, KeepAMachineOfTheUsersInTheStore) {
  const auto machine =
      write(folder_, "machine.toml", read(RICOCHET_SOURCE "/examples/machine.toml"));
  const auto plan =
      write(folder_, "own.toml",
            "name = \"own\"\n[[scene]]\nname = \"mine\"\nfile = \"" + machine.string() +
                "\"\n[[part]]\nproblems = [\"top-speed-*\"]\n"
                "machines = { around = \"mine\", restitution = [0.3, 0.5] }\n"
                "solvers = [\"bisection\"]\nbudgets = [20]\ninstances = 2\n");
  const auto run_shard = [&](const std::string& out, const std::string& rest) {
    return out_of(fmt::format("run {} --out {} {}", plan.string(), (folder_ / out).string(), rest));
  };
  run_shard("whole", "");
  run_shard("one", "--shard 1/2");
  run_shard("two", "--shard 2/2");
  std::filesystem::remove(machine);
  out_of(
      fmt::format("merge {} {} {}", (folder_ / "all.sqlite").string(), store("one"), store("two")));
  EXPECT_EQ(out_of("digest " + (folder_ / "all.sqlite").string()),
            out_of("digest " + store("whole")));
  const std::string again = out_of("replay " + store("whole") + " 1");
  EXPECT_THAT(again, HasSubstr("top-speed-mine-r0.3"));
  EXPECT_THAT(again, HasSubstr("The same, to the last bit."));
}

TEST_F(CampaignCommands, RefuseAStoreThatIsThereUnlessToldToGoOn) {
  run("one");
  const std::string before = read(store("one"));
  expect_refusal(command("one"), "is there already: --resume goes on");
  EXPECT_TRUE(read(store("one")) == before) << "it has changed";
}

TEST_F(CampaignCommands, LeaveAStoreOfAnotherPlanAsItIs) {
  run("one");
  const std::string before = read(store("one"));
  const auto other = write(folder_, "other.toml", std::string(small_plan) + "seeds = 2\n");
  expect_refusal(
      fmt::format("run {} --out {} --resume", other.string(), (folder_ / "one").string()),
      "is of another plan: choose another --out");
  EXPECT_TRUE(read(store("one")) == before) << "it has changed";
  run("other", "--shard 1/2");
  expect_refusal(
      fmt::format("merge {0}/all.sqlite {0}/one/runs.sqlite {0}/missing.sqlite", folder_.string()),
      "missing.sqlite");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "all.sqlite"));
}

TEST_F(CampaignCommands, LeaveWhatIsNoStoreOrDamagedAsItIs) {
  run("one");
  std::string damaged = read(store("one"));
  for (std::size_t k = damaged.size() / 3; k < damaged.size() / 2; ++k) damaged[k] ^= 0x55;
  for (const std::string& text : {std::string("my diary\n"), std::string(), damaged}) {
    std::filesystem::create_directories(folder_ / "foreign");
    write(folder_ / "foreign", "runs.sqlite", text);
    expect_refusal(command("foreign", "--resume"), "runs.sqlite");
    expect_refusal("digest " + store("foreign"), "runs.sqlite");
    expect_refusal("replay " + store("foreign") + " 1", "runs.sqlite");
    EXPECT_TRUE(read(store("foreign")) == text) << "it has changed";
  }
}

TEST_F(CampaignCommands, RefuseAShardThatIsNone) {
  for (const std::string shard : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/2x"}) {
    expect_refusal(command("none", "--shard " + shard), "must be I/N");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
  }
}

TEST_F(CampaignCommands, RefuseABadPlanAndLeaveNoTrace) {
  const auto bad = write(folder_, "bad.toml", std::string(small_plan) + "instance = 3\n");
  for (const std::string& start : std::vector<std::string>{
           "plan check ", "plan slurm ", "run --out " + (folder_ / "none").string() + " "}) {
    expect_refusal(start + bad.string(), "there is no key instance; did you mean instances?");
    expect_refusal(start + (folder_ / "missing.toml").string(), "missing.toml");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
  }
  expect_refusal(command("none", "--jobs -1"), "--jobs -1: must be >= 0");
  expect_refusal("plan slurm --jobs 0 " + plan_, "--jobs 0: must be from 1 to 10000");
}

TEST_F(CampaignCommands, SayThatAnotherOneIsAtWork) {
  const FolderLock first(folder_ / "one");
  expect_refusal(command("one", "--resume"), "another ricochet is at work there");
}

/// The script, with a loop in Slurm's place.
TEST_F(CampaignCommands, PrintAScriptForSlurmWhoseLastJobJoinsAll) {
  run("one");
  const auto plan = write(folder_, "it's & <mine>.toml", small_plan);
  const auto script = write(folder_, "campaign.sh",
                            out_of(fmt::format("plan slurm --jobs 3 \"{}\"", plan.string())));
  EXPECT_THAT(read(script), HasSubstr("#SBATCH --array=1-3\n"));
  EXPECT_THAT(read(script), HasSubstr("#SBATCH --time=1:00:00\n"));
  const std::string jobs = fmt::format(
      "cd {} && for i in 2 3 1 2; do RICOCHET={} SLURM_ARRAY_TASK_ID=$i bash campaign.sh || exit "
      "1; "
      "done >out 2>err",
      folder_.string(), RICOCHET_PROGRAM);
  ASSERT_EQ(std::system(jobs.c_str()), 0) << read(folder_ / "err");
  EXPECT_EQ(out_of("digest " + (folder_ / "campaign" / "runs.sqlite").string()), digest("one"));
}

/// mpirun, where there is one and the program for it; else empty.
std::string mpirun() {
  const bool there = std::filesystem::exists(RICOCHET_PROGRAM "-mpi") &&
                     std::system("mpirun --version >/dev/null 2>&1") == 0;
  return there ? "mpirun --allow-run-as-root --oversubscribe" : "";
}

TEST_F(CampaignCommands, GiveTheSameDigestOverTheRanksOfMpi) {
  if (mpirun().empty()) GTEST_SKIP() << "there is no MPI";
  run("one");
  for (const int ranks : {2, 4}) {
    const std::string out = fmt::format("ranks-{}", ranks);
    const std::string call = fmt::format("{} -n {} {} {} >{}/log 2>&1", mpirun(), ranks,
                                         RICOCHET_PROGRAM, command(out), folder_.string());
    ASSERT_EQ(std::system(call.c_str()), 0) << read(folder_ / "log");
    EXPECT_THAT(read(folder_ / "log"), HasSubstr("digest " + digest("one")));
    EXPECT_EQ(digest(out), digest("one"));
  }
}

TEST_F(CampaignCommands, LoseNothingButItsRunsWithARankThatIsKilled) {
  if (mpirun().empty()) GTEST_SKIP() << "there is no MPI";
  run("one");
  // The oldest rank but one is killed as soon as there are runs.
  const std::string call = fmt::format(
      "{} -n 3 {} {} >{}/log 2>&1 & it=$!; while [ ! -e {} ] && kill -0 $it; do sleep 0.05; done; "
      "sleep 0.3; kill -9 $(pgrep -P $it | sed -n 2p); wait $it",
      mpirun(), RICOCHET_PROGRAM, command("ranks"), folder_.string(), store("ranks"));
  static_cast<void>(std::system(("(" + call + ") >/dev/null 2>&1").c_str()));
  for (int k = 0;
       k < 50 && call_interrupted("KILL", command("ranks", "--resume"), 60).exit_code == 2; ++k) {
    static_cast<void>(std::system("sleep 0.1"));  // the process of the store still ends
  }
  EXPECT_EQ(digest("ranks"), digest("one"));
}

TEST_F(CampaignCommands, LoseNothingWhereverTheyAreKilled) {
  const std::string kills = fmt::format("{}/tests/hostile/kills {} 3 >{}/log 2>&1", RICOCHET_SOURCE,
                                        RICOCHET_PROGRAM, folder_.string());
  EXPECT_EQ(std::system(kills.c_str()), 0) << read(folder_ / "log");
}

}  // namespace
}  // namespace ricochet::cli
