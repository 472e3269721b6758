#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solvers/outside/line_solver.h"
#include "src/core/process.h"
#include "tests/solvers/outside/scripts.h"

namespace ricochet::outside {
namespace {

using std::chrono::steady_clock;
using testing::HasSubstr;
using testing::Not;
using testing::Optional;

/// A shell that carries out these lines.
std::vector<std::string> shell(const std::string& lines) {
  return {"sh", "-c", lines};
}

std::string reason_of(LineProgram& program, const Patience& patience = {}) {
  try {
    program.line(patience);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LineProgram, ExchangesLines) {
  LineProgram program({"cat"});
  for (const std::string text : {"one", "", "three"}) {
    program.send(text + "\n");
    EXPECT_THAT(program.line(), Optional(std::string_view(text)));
  }
  EXPECT_EQ(program.lines(), 3);
}

TEST(LineProgram, PutsPartsOfALineTogether) {
  LineProgram program(shell("printf 'one, '; sleep 0.1; printf 'two\\nthr'; sleep 0.1; echo ee"));
  EXPECT_THAT(program.line(), Optional(std::string_view("one, two")));
  EXPECT_THAT(program.line(), Optional(std::string_view("three")));
  EXPECT_EQ(program.line(), std::nullopt);
}

TEST(LineProgram, TakesTheLastLineWithoutItsNewline) {
  LineProgram program(shell("printf 'one\\ntwo'"));
  EXPECT_THAT(program.line(), Optional(std::string_view("one")));
  EXPECT_THAT(program.line(), Optional(std::string_view("two")));
  EXPECT_EQ(program.line(), std::nullopt);
  EXPECT_EQ(program.line(), std::nullopt);
}

TEST(LineProgram, SaysHowItEnded) {
  const auto end_of = [](const std::vector<std::string>& arguments) {
    LineProgram program(arguments);
    EXPECT_EQ(program.line(), std::nullopt);
    return program.how_it_ended();
  };
  EXPECT_EQ(end_of(shell("exit 0")), "ended with exit code 0");
  EXPECT_EQ(end_of(shell("exit 3")), "ended with exit code 3");
  EXPECT_EQ(end_of(shell("kill -SEGV $$")), "was ended by signal 11, Segmentation fault");
  EXPECT_EQ(end_of({"there/is/no/such"}), "ended with exit code 127: there is no such program");
  EXPECT_EQ(end_of({"/etc/passwd"}), "ended with exit code 126: it cannot be run");
  EXPECT_EQ(end_of(shell("exec >&-; exec sleep 30")), "closed its standard output");
}

TEST(LineProgram, IsNoEndlessWaitWhereItsChildrenLiveOn) {
  const auto start = steady_clock::now();
  {
    LineProgram program(shell("sleep 30 2>/dev/null & echo one"));
    EXPECT_THAT(program.line(), Optional(std::string_view("one")));
    EXPECT_EQ(program.line(), std::nullopt);
  }
  EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(LineProgram, SurvivesThatNobodyReadsWhatItSends) {
  LineProgram program(shell("exec <&-; echo one; sleep 0.1"));
  EXPECT_THAT(program.line(), Optional(std::string_view("one")));
  program.send("no one reads this\n");
  program.send(std::string(1 << 20, 'x') + "\n");
  EXPECT_EQ(program.line(), std::nullopt);
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0) << "nothing is left to be delivered later";
}

TEST(LineProgram, TakesALongLineWhileItAnswersWithAnother) {
  LineProgram program({"cat"});  // writes while it reads: more than both pipes hold
  const std::string text(3 << 20, 'x');
  program.send(text + "\n");
  EXPECT_THAT(program.line(), Optional(std::string_view(text)));
}

TEST(LineProgram, BoundsALine) {
  LineProgram program(shell("head -c 100000000 /dev/zero"));
  EXPECT_EQ(reason_of(program), "a line of more than 4 MiB");
}

TEST(LineProgram, BoundsWhatIsWrittenWithoutReading) {
  LineProgram program({"yes"});
  const auto send_much = [&] {
    for (int k = 0; k < 100; ++k) program.send(std::string(1 << 20, 'x') + "\n");
  };
  EXPECT_THROW(send_much(), std::runtime_error);
}

TEST(LineProgram, WaitsNoLongerThanItIsTold) {
  LineProgram program(shell("exec sleep 30"));
  EXPECT_EQ(
      reason_of(program, Patience{std::chrono::seconds(1), "it was started"}),
      "wrote nothing for 1 s after it was started; no line received yet; are its lines flushed?");
}

TEST(LineProgram, IsReportedWhileItIsWaitedFor) {
  std::vector<std::string> told;
  on_waiting([&told](const std::string& text) { told.push_back(text); });
  LineProgram program(shell("echo one; sleep 0.6; echo two; sleep 30"));
  const Patience impatient{std::chrono::seconds(2), "it was asked", std::chrono::milliseconds(300)};
  EXPECT_THAT(program.line(impatient), Optional(std::string_view("one")));
  EXPECT_THAT(program.line(impatient), Optional(std::string_view("two")));
  const std::string command = "sh -c echo one; sleep 0.6; echo two; sleep 30";
  EXPECT_THAT(told,
              testing::ElementsAre("waiting for " + command + "; last line received: one", ""))
      << "and told when the wait is over";
  EXPECT_EQ(reason_of(program, impatient),
            "wrote nothing for 2 s after it was asked; last line received: two; are its lines "
            "flushed?");
  EXPECT_EQ(told.back(), "waiting for " + command + "; last line received: two");
  on_waiting({});
}

TEST(LineProgram, IsReportedInALineThatIsSafeOnATerminal) {
  std::vector<std::string> told;
  on_waiting([&told](const std::string& text) { told.push_back(text); });
  LineProgram program(shell("printf '\\033[31m\\n'; sleep 30 # \x1b[32m"));
  const Patience impatient{std::chrono::seconds(1), "it was asked", std::chrono::milliseconds(300)};
  EXPECT_THAT(program.line(impatient), Optional(std::string_view("\x1b[31m")));
  EXPECT_THAT(reason_of(program, impatient), HasSubstr("last line received: \\x1b[31m;"));
  EXPECT_THAT(told, testing::Contains(testing::AllOf(HasSubstr("# \\x1b[32m; last line received: "
                                                               "\\x1b[31m"),
                                                     Not(HasSubstr("\x1b")))));
  on_waiting({});
}

TEST(LineProgram, LeavesNothingBehindAWrapper) {
  const auto folder = fresh_folder();
  for (const std::string how : {"", "setsid "}) {
    pid_t hidden = 0;
    {
      LineProgram program(shell(how + "sh -c 'echo $$; exec sleep 1000' & wait"));
      hidden = std::stoi(std::string(*program.line()));
      EXPECT_EQ(kill(hidden, 0), 0);
    }
    EXPECT_EQ(kill(hidden, 0), -1) << how;
  }
}

TEST(LineProgram, EndsWithItsObject) {
  const auto folder = fresh_folder();
  const auto pid_of = [&](const std::string& lines) {
    LineProgram program(shell("echo $$; " + lines));
    return std::stoi(std::string(*program.line()));
  };
  EXPECT_EQ(kill(pid_of("cat; echo ended > " + (folder / "how").string()), 0), -1);
  EXPECT_EQ(read(folder / "how"), "ended\n") << "by itself";
  EXPECT_EQ(kill(pid_of("while true; do sleep 0.1; done"), 0), -1) << "by force";
}

TEST(LineProgram, EndsWithTheThreadThatStartedIt) {
  std::unique_ptr<LineProgram> program;
  std::thread([&] {
    program = std::make_unique<LineProgram>(shell("echo here; while true; do sleep 0.1; done"));
    EXPECT_TRUE(program->is_of_this_thread());
    EXPECT_THAT(program->line(), Optional(std::string_view("here")));
  }).join();
  EXPECT_FALSE(program->is_of_this_thread());
  EXPECT_EQ(program->line(), std::nullopt);
  EXPECT_EQ(program->how_it_ended(), "was ended by signal 9, Killed");
}

TEST(LineProgram, IsLeftAloneByACopyOfItsProcess) {
  auto program = std::make_unique<LineProgram>(std::vector<std::string>{"cat"});
  const pid_t copy = fork();
  if (copy == 0) {
    const bool is_ours = program->is_of_this_thread();
    const auto start = steady_clock::now();
    program.reset();
    const bool waited = steady_clock::now() - start > std::chrono::milliseconds(900);
    _exit(is_ours ? 1 : waited ? 2 : 0);
  }
  int status = 0;
  waitpid(copy, &status, 0);
  EXPECT_EQ(status, 0);
  program->send("still here\n");
  EXPECT_THAT(program->line(), Optional(std::string_view("still here")));
}

TEST(LineProgram, KeepsItsStreamsFromOthers) {
  const auto how = fresh_folder() / "how";
  auto first = std::make_unique<LineProgram>(shell("cat; echo ended > " + how.string()));
  const LineProgram second({"cat"});
  first.reset();
  EXPECT_EQ(read(how), "ended\n") << "by itself: the second does not hold its input open";
}

TEST(LineProgram, HasSpokenWhenSomethingWasNotRead) {
  LineProgram program(shell("echo one; echo two; read line; read line"));
  program.line();
  while (!program.has_spoken()) std::this_thread::yield();
  program.line();
  EXPECT_FALSE(program.has_spoken());
}

}  // namespace
}  // namespace ricochet::outside
