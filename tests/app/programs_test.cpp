#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

/// A folder with two programs, which leave a file when they are started, and a plan that names
/// them.
class Programs : public testing::Test {
 protected:
  Programs() {
    for (const char* name : {"first", "second"}) {
      write(folder_, std::string(name) + ".sh",
            fmt::format("touch {0}/{1}.started\n"
                        "echo '{{\"name\": \"{1}\"}}'\n"
                        "while read -r problem; do\n"
                        "  echo '{{\"ask\": [1]}}'; read -r answer; echo '{{\"done\": \"done\"}}'\n"
                        "done\n",
                        folder_.string(), name));
    }
    plan_ =
        write(folder_, "plan.toml",
              fmt::format("name = \"programs\"\n[[part]]\nproblems = [\"count-C1\"]\n"
                          "formulations = [\"count\"]\n"
                          "solvers = [\"scan\", \"{}\", \"{}\"]\nbudgets = [5]\ninstances = 2\n",
                          command("first"), command("second")))
            .string();
  }

  std::string command(const std::string& name) const {
    return "sh " + (folder_ / name).string() + ".sh";
  }
  bool started(const std::string& name) const { return fs::exists(folder_ / (name + ".started")); }
  void forget_starts() const {
    for (const char* name : {"first", "second"})
      fs::remove(folder_ / (std::string(name) + ".started"));
  }

  fs::path folder_ = fresh_folder();
  std::string plan_;
};

TEST_F(Programs, AreListedByACheckThatStartsNone) {
  const Outcome text = call("plan check " + plan_);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("run would start: " + command("first") + "\n"));
  EXPECT_THAT(text.out, HasSubstr("run would start: " + command("second") + "\n"));
  const json data = json::parse(call("plan check --format json " + plan_).out);
  EXPECT_EQ(data["programs"], (json{command("first"), command("second")}));
  EXPECT_EQ(data["runs"], 6);
  EXPECT_FALSE(started("first"));
  EXPECT_FALSE(started("second"));
}

TEST_F(Programs, TakeATimeThatACheckDoesNotKnow) {
  EXPECT_THAT(call("plan check " + plan_).out, HasSubstr("; at least "));
  EXPECT_EQ(json::parse(call("plan check --format json " + plan_).out)["at_least"], true);
  EXPECT_THAT(call("plan check quick").out, HasSubstr("; about "));
  EXPECT_THAT(call("plan slurm " + plan_).out, HasSubstr("# The time below is at least needed"));
  EXPECT_THAT(call("plan slurm quick").out, Not(HasSubstr("at least")));
  const auto out = (folder_ / "out").string();
  EXPECT_THAT(call("run " + plan_ + " --allow-programs --out " + out).err, HasSubstr("\nabout "));
}

TEST_F(Programs, AreNamedInAScriptForSlurm) {
  const Outcome script = call("plan slurm " + plan_);
  EXPECT_THAT(script.out, HasSubstr("# It starts: " + command("second") + "\n"));
  EXPECT_THAT(script.out, HasSubstr(" --allow-programs "));
  EXPECT_FALSE(started("first"));
  EXPECT_THAT(call("plan slurm quick").out, Not(HasSubstr("--allow-programs")));
}

TEST_F(Programs, AreShownInALineEach) {
  const auto plan = write(folder_, "odd.toml",
                          "[[part]]\nproblems = \"hs-71\"\n"
                          "solvers = [\"scan\", \"sh -c '\\u001b[31m\\ntouch evil'\"]\n"
                          "budgets = 5\n");
  const std::string shown = "sh -c '\\x1b[31m\\x0atouch evil'\n";
  EXPECT_THAT(call("plan check " + plan.string()).out, HasSubstr("run would start: " + shown));
  EXPECT_THAT(call("plan slurm " + plan.string()).out, HasSubstr("# It starts: " + shown))
      << "else its second line would be a command";
}

TEST_F(Programs, OfAPlanRunOnlyWhereTheyAreAllowed) {
  const std::string out = (folder_ / "out").string();
  expect_refusal(fmt::format("run {} --out {}", plan_, out),
                 fmt::format("{}: names programs, which run with your rights: {}; {}; add "
                             "--allow-programs if you trust them",
                             plan_, command("first"), command("second")));
  EXPECT_FALSE(started("first"));
  EXPECT_FALSE(fs::exists(out));
  const Outcome run = call(fmt::format("run {} --out {} --allow-programs", plan_, out));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, testing::StartsWith("starts " + command("first") + "\nstarts " +
                                           command("second") + "\n"));
  EXPECT_TRUE(started("first"));
}

TEST_F(Programs, OfAStoreAreStartedForTheirOwnRunsOnly) {
  const std::string store = (folder_ / "out" / "runs.sqlite").string();
  ASSERT_EQ(
      call(fmt::format("run {} --out {}/out --allow-programs", plan_, folder_.string())).exit_code,
      0);
  int seen = 0;
  for (int number = 1; number <= 6; ++number) {
    forget_starts();
    const std::string replay = fmt::format("replay {} {} --format json", store, number);
    const Outcome unasked = call(replay);
    EXPECT_FALSE(started("first") || started("second"));
    const json again = json::parse(call(replay + " --allow-programs").out);
    EXPECT_EQ(again["same"], true);
    const std::string solver = again["solver"];
    EXPECT_EQ(started("first"), solver == "first");
    EXPECT_EQ(started("second"), solver == "second");
    EXPECT_EQ(unasked.exit_code, solver == "scan" ? 0 : 2) << solver;
    if (solver != "scan") {
      ++seen;
      EXPECT_THAT(unasked.err, HasSubstr("run with your rights: " + command(solver) + "; add"));
    }
  }
  EXPECT_EQ(seen, 4);
  for (const std::string reading :
       {"digest ", "export --format csv --out /dev/null/x ", "merge /dev/null/x "}) {
    forget_starts();
    call(reading + store);
    EXPECT_FALSE(started("first") || started("second")) << reading;
  }
}

TEST_F(Programs, GivenByACommandNeedNoPermission) {
  const Outcome solved = call("solve '" + command("first") + "' count-C1");
  EXPECT_EQ(solved.exit_code, 0) << solved.err;
  EXPECT_TRUE(started("first"));
}

}  // namespace
}  // namespace ricochet::cli
