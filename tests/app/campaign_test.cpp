#include "src/core/files.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::ContainsRegex;

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

std::string digest(const std::string& out) {
  return out_of("digest {}/runs.sqlite", out);
}

class CampaignCommands : public testing::Test {
 protected:
  void SetUp() override { write("plan.toml", small_plan); }

  static std::string command(const std::string& out, const std::string& rest = "") {
    return filled("run plan.toml --out {} {}", out, rest);
  }

  static std::string run(const std::string& out, const std::string& rest = "") {
    return out_of(command(out, rest));
  }

  /// A part of random search on one problem.
  static std::string part(const std::string& problem, int budget, int instances = 2) {
    return filled(
        "[[part]]\nproblems = \"{}\"\nsolvers = \"random-search\"\nbudgets = {}\n"
        "instances = {}\n",
        problem, budget, instances);
  }

  /// The store's file and what lies beside it under its name.
  static std::vector<std::string> files_of_store(const std::string& out) {
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(here() / out)) {
      const std::string name = file.path().filename();
      if (name.starts_with("runs.sqlite")) names.push_back(name);
    }
    return names;
  }

  /// What digest says once the processes that made runs have noticed that the program was killed.
  static std::string said_after_kill(const std::string& out) {
    std::string said = "is adding runs";
    for (int k = 0; k < 100 && said.find("is adding runs") != std::string::npos; ++k) {
      said = call_in_shell(filled("sleep 0.1; ricochet digest {}/runs.sqlite", out)).err;
    }
    return said;
  }
};

TEST_F(CampaignCommands, ReportOnAFamilyThatSeveralPartsAskFor) {
  write("plan.toml", part("profile-count-2-C1", 10) + part("profile-count-4-C1", 100) +
                         part("profile-count-4-C1", 190) + "name = \"again\"\n" +
                         part("count-C4", 5) + part("count-C1", 7));
  const std::string said = run("one");
  EXPECT_THAT(said, AllOf(ContainsRegex("\ncount +5 "), ContainsRegex("\ncount-part-5 +7 ")));
  const std::string page = read("one/profile-count/index.html");
  for (const char* family : {"profile-count", "profile-count-part-2", "profile-count-again"}) {
    EXPECT_THAT(page, HasSubstr(filled("<div class=\"choice\" id=\"{}\"", family)));
  }
}

TEST_F(CampaignCommands, SayNothingOfTheirProgressWhereTheyAreToBeQuiet) {
  EXPECT_THAT(call(command("loud")).err, HasSubstr("3 solvers on 2 problems"));
  EXPECT_EQ(call(command("quiet", "--quiet")).err, "");
  EXPECT_EQ(call(command("quiet", "--quiet --resume")).err, "");
}

TEST_F(CampaignCommands, SayHowManyRunsThereAreAndHowLongTheyTook) {
  const Json size = json_of("plan check plan.toml");
  const int runs = size["runs"];
  EXPECT_GT(size["seconds"], 0);
  EXPECT_EQ(size["cells"].get<int>() * 3, runs) << "instances";
  EXPECT_THAT(out_of("plan check plan.toml"),
              StartsWith(filled("{} runs of 3 solvers on 2 problems", runs)));
  const auto start = std::chrono::steady_clock::now();
  const std::string said = run("one");
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_THAT(said, HasSubstr(filled("{} runs: one/runs.sqlite", runs)));
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
  EXPECT_THAT(out_of("merge runs.sqlite second first"), EndsWith("digest " + whole));
  EXPECT_EQ(digest("."), whole);
  run("first", "--shard 2/2 --resume");
  EXPECT_EQ(digest("first"), whole);
}

TEST_F(CampaignCommands, TellASolverWithOptionsOfItsOwn) {
  const std::string text =
      "[[solver]]\nname = \"bbfwa-40\"\nof = \"bbfwa\"\noptions = { sparks = 40 }\n"
      "[[part]]\nproblems = \"count-C4\"\nsolvers = \"bbfwa*\"\nbudgets = 50\ninstances = 2\n";
  write("plan.toml", text);
  run("made");
  EXPECT_THAT(read("made/solvers/index.html"), HasSubstr("sparks 40"));
  for (const int number : {1, 2, 3, 4}) out_of("replay made {}", number);
  write("bad.toml", "[[solver]]\nname = \"s\"\nof = \"scan\"\noptions = { sparks = 40 }\n" + text);
  expect_refusal("plan check bad.toml", "solver s: scan: no such solver has options");
}

TEST_F(CampaignCommands, NeedFewOpenFilesAndSayWhenThereAreFewer) {
  const std::string limited = "ulimit -n {}; ricochet run plan.toml --out few --quiet --jobs 1";
  const Outcome few = call_in_shell(filled(limited, 12));
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_THAT(few.err, HasSubstr("ricochet: too many open files: the limit is 12; raise it "
                                 "with ulimit -n "));
  EXPECT_FALSE(exists("few"));
  const Outcome enough = call_in_shell(filled(limited, 40));
  EXPECT_EQ(enough.exit_code, 0) << enough.err;
  run("usual");
  EXPECT_EQ(digest("few"), digest("usual"));
}

TEST_F(CampaignCommands, GoOnWhereTheyWereInterrupted) {
  run("whole");
  for (const std::string signal : {"INT", "KILL"}) {
    int interruptions = 0;
    for (int k = 1; k <= 20 && interruptions < 3; ++k) {
      const Outcome outcome =
          call_in_shell(filled("timeout --signal={} {} ricochet {}", signal, 0.05 * k * k,
                               command(signal, "--resume --quiet")));
      if (outcome.exit_code == 0) break;
      if (!exists(signal + "/runs.sqlite")) continue;
      ++interruptions;
      if (signal == "KILL") said_after_kill(signal);
      EXPECT_THAT(files_of_store(signal), ElementsAre("runs.sqlite")) << signal;
    }
    EXPECT_GT(interruptions, 0) << signal;
    run(signal, "--resume");
    EXPECT_EQ(digest(signal), digest("whole")) << signal;
  }
}

TEST_F(CampaignCommands, WarnOfRunsThatMayBeMissing) {
  write("plan.toml", part("count-C4", 100, 100'000));
  call_interrupted("KILL", command("long", "--quiet"), 3);
  fs::create_directory(here() / "copy\x1b[31m");
  fs::copy(here() / "long/runs.sqlite", here() / "copy\x1b[31m/runs.sqlite");
  const std::string copy = "'copy\x1b[31m/runs.sqlite'";
  for (const char* reader :
       {"digest {}", "merge merged.sqlite {}", "export {} --format csv --out csv", "replay {} 1"}) {
    EXPECT_THAT(call(reader, copy).err, AllOf(HasSubstr("runs may be missing"),
                                              HasSubstr("copy\\x1b[31m/"), Not(HasSubstr("\x1b"))))
        << reader;
  }
  EXPECT_THAT(said_after_kill("long"), AllOf(Not(HasSubstr("runs may be missing")),
                                             HasSubstr(" of 200000 planned runs are present, ")));
  EXPECT_THAT(files_of_store("long"), ElementsAre("runs.sqlite"));
}

TEST_F(CampaignCommands, NameFilesSafelyForATerminal) {
  for (const char* arguments :
       {"run plan.toml --out '{0}'", "report '{0}'", "merge '{0}.sqlite' '{0}/runs.sqlite'",
        "export '{0}/runs.sqlite' --format csv --out '{0}/tables'"}) {
    EXPECT_THAT(out_of(arguments, "odd\x1b[31m"),
                AllOf(HasSubstr("odd\\x1b[31m"), Not(HasSubstr("\x1b"))))
        << arguments;
  }
}

TEST_F(CampaignCommands, SayHowToGoOn) {
  write("plan.toml", part("count-C4", 1000, 10'000));
  for (const auto& [arguments, how] :
       {std::pair("run plan.toml", "--resume goes on\n"),
        {"compare --problems hs-71 --solvers random-search --budget 1000 --instances 10000",
         "the same command goes on\n"}}) {
    const Outcome outcome = call_interrupted("INT", filled("{} --quiet --out long", arguments), 2);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err,
                EndsWith(filled("ricochet: interrupted; finished runs are kept: {}", how)));
    fs::remove_all(here() / "long");
  }
}

TEST_F(CampaignCommands, MakeARunAgainToTheLastBit) {
  run("one");
  for (const int number : {1, 17, 50}) {
    const Json again = json_of("replay one {}", number);
    EXPECT_EQ(again["same"], true) << again;
    EXPECT_EQ(again["run"], number);
    std::string key;
    for (const char* part : {"problem", "formulation", "perturbation", "solver", "budget",
                             "gradient_price", "instance", "seed"}) {
      const Json& name = again[part];
      key += (key.empty() ? "" : "/") + (name.is_string() ? name.get<std::string>() : name.dump());
    }
    EXPECT_EQ(json_of("replay one {}", key), again);
  }
  EXPECT_THAT(out_of("replay one 3"), EndsWith("The same, to the last bit.\n"));
  expect_refusal("replay one a/b/c/d/10/n/1/0", "the campaign has no problem a");
  expect_refusal("replay one first", "run first: must be a number, or PROBLEM/");
  expect_refusal("replay one 0", "there is no run 0");
  expect_refusal("replay one 100000", "there is no run 100000");
}

TEST_F(CampaignCommands, KeepAMachineOfTheUsersInTheStore) {
  write("machine.toml", read(RICOCHET_SOURCE "/examples/machine.toml"));
  write("plan.toml",
        "name = \"own\"\n[[scene]]\nname = \"mine\"\nfile = \"machine.toml\"\n"
        "[[part]]\nproblems = [\"top-speed-*\"]\n"
        "machines = { around = \"mine\", restitution = [0.3, 0.5] }\n"
        "solvers = [\"bisection\"]\nbudgets = [20]\ninstances = 2\n");
  run("whole");
  run("one", "--shard 1/2");
  run("two", "--shard 2/2");
  fs::remove(here() / "machine.toml");
  out_of("merge runs.sqlite one two");
  EXPECT_EQ(digest("."), digest("whole"));
  EXPECT_THAT(out_of("replay whole 1"),
              AllOf(HasSubstr("top-speed-mine-r0.3"), HasSubstr("The same, to the last bit.")));
}

TEST_F(CampaignCommands, LeaveAStoreAsItIsUnlessToldToGoOnWithItsPlan) {
  run("one");
  const std::string before = read("one/runs.sqlite");
  expect_refusal(command("one"), "is there already: --resume goes on");
  write("other.toml", std::string(small_plan) + "seeds = 2\n");
  expect_refusal("run other.toml --out one --resume", "is of another plan: choose another --out");
  EXPECT_TRUE(read("one/runs.sqlite") == before) << "it has changed";
  expect_refusal("merge all.sqlite one/runs.sqlite missing.sqlite", "missing.sqlite");
  EXPECT_FALSE(exists("all.sqlite"));
  const auto nothing = HasSubstr("fresh/runs.sqlite: is not there: there is nothing to resume");
  EXPECT_THAT(call(command("fresh", "--resume")).err, nothing);
  EXPECT_THAT(call(command("fresh", "--resume")).err, Not(HasSubstr("nothing to resume")));
  EXPECT_THAT(call(command("other")).err, Not(HasSubstr("nothing to resume")));
}

TEST_F(CampaignCommands, LeaveWhatIsNoStoreOrDamagedAsItIs) {
  run("one");
  std::string damaged = read("one/runs.sqlite");
  for (std::size_t k = damaged.size() / 3; k < damaged.size() / 2; ++k) damaged[k] ^= 0x55;
  for (const std::string& text : {std::string("my diary\n"), std::string(), damaged}) {
    write("foreign/runs.sqlite", text);
    for (const char* arguments :
         {"run plan.toml --out foreign --resume", "digest foreign", "replay foreign 1"}) {
      expect_refusal(arguments, "runs.sqlite");
    }
    EXPECT_TRUE(read("foreign/runs.sqlite") == text) << "it has changed";
  }
}

TEST_F(CampaignCommands, SayThatAnotherOneIsAtWork) {
  const FolderLock first(here() / "one");
  expect_refusal(command("one", "--resume"), "another ricochet is at work there");
}

/// The script, with a loop in Slurm's place.
TEST_F(CampaignCommands, PrintAScriptForSlurmWhoseLastJobJoinsAll) {
  run("one");
  write("it's & <mine>.toml", small_plan);
  const std::string script = out_of("plan slurm --jobs 3 \"it's & <mine>.toml\"");
  write("campaign.sh", script);
  EXPECT_THAT(script,
              AllOf(HasSubstr("#SBATCH --array=1-3\n"), HasSubstr("#SBATCH --time=1:00:00\n")));
  const Outcome jobs = call_in_shell(
      "export RICOCHET=" RICOCHET_PROGRAM
      "; for i in 2 3 1 2; do SLURM_ARRAY_TASK_ID=$i bash campaign.sh || exit 1; done");
  ASSERT_EQ(jobs.exit_code, 0) << jobs.err;
  EXPECT_EQ(digest("campaign"), digest("one"));
}

const std::string mpirun = "mpirun --allow-run-as-root --oversubscribe";

/// Why there is no mpirun, or no program for it.
std::string no_mpi() {
  if (call_in_shell("mpirun --version").exit_code != 0) return "there is no MPI";
  return missing({RICOCHET_PROGRAM "-mpi"});
}

TEST_F(CampaignCommands, GiveTheSameDigestOverTheRanksOfMpi) {
  if (const auto reason = no_mpi(); !reason.empty()) GTEST_SKIP() << reason;
  run("one");
  for (const int ranks : {2, 4}) {
    const std::string out = filled("ranks-{}", ranks);
    const Outcome outcome =
        call_in_shell(filled("{} -n {} " RICOCHET_PROGRAM " {}", mpirun, ranks, command(out)));
    EXPECT_THAT(outcome.out, HasSubstr("digest " + digest("one"))) << outcome.err;
    EXPECT_EQ(digest(out), digest("one"));
  }
}

TEST_F(CampaignCommands, LoseNothingButItsRunsWithARankThatIsKilled) {
  if (const auto reason = no_mpi(); !reason.empty()) GTEST_SKIP() << reason;
  run("one");
  // The oldest rank but one is killed as soon as there are runs.
  call_in_shell(filled("{} -n 3 " RICOCHET_PROGRAM
                       " {} & it=$!; while [ ! -e ranks/runs.sqlite ] && kill -0 $it; do "
                       "sleep 0.05; done; sleep 0.3; kill -9 $(pgrep -P $it | sed -n 2p); wait $it",
                       mpirun, command("ranks")));
  for (int k = 0;
       k < 50 && call_interrupted("KILL", command("ranks", "--resume"), 60).exit_code == 2; ++k) {
    call_in_shell("sleep 0.1");  // the process of the store still ends
  }
  EXPECT_EQ(digest("ranks"), digest("one"));
}

}  // namespace
}  // namespace ricochet::cli
