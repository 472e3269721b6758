#include <signal.h>

#include "solvers/outside/line_solver.h"
#include "src/core/process.h"
#include "tests/solvers/solve.h"

namespace ricochet::outside {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;
using testing::Optional;

/// A shell that carries out these lines.
std::vector<std::string> shell(const std::string& lines) {
  return {"sh", "-c", lines};
}

/// All lines until the shell ends, or has no more.
std::vector<std::string> all_lines(const std::string& commands, const Patience& patience = {}) {
  LineProgram program(shell(commands));
  std::vector<std::string> lines;
  while (const auto line = program.line(patience)) lines.emplace_back(*line);
  EXPECT_EQ(program.line(patience), std::nullopt) << "still none";
  return lines;
}

std::string reason_of(LineProgram& program, const Patience& patience = {}) {
  return complaint_of<std::runtime_error>([&] { return program.line(patience); });
}

TEST(LineProgram, ExchangesLines) {
  LineProgram program({"cat"});  // writes while it reads: more than both pipes hold
  for (const std::string& text : {std::string("one"), std::string(), std::string(3 << 20, 'x')}) {
    program.send(text + "\n");
    EXPECT_THAT(program.line(), Optional(std::string_view(text)));
  }
  EXPECT_EQ(program.lines(), 3);
}

TEST(LineProgram, PutsPartsOfALineTogetherAndTakesTheLastWithoutItsNewline) {
  EXPECT_THAT(all_lines("printf 'one, '; sleep 0.1; printf 'two\\nthr'; sleep 0.1; echo ee"),
              ElementsAre("one, two", "three"));
  EXPECT_THAT(all_lines("printf 'one\\ntwo'"), ElementsAre("one", "two"));
}

TEST(LineProgram, SaysHowItEnded) {
  const std::pair<std::vector<std::string>, const char*> ends[] = {
      {shell("exit 0"), "ended with exit code 0"},
      {shell("exit 3"), "ended with exit code 3"},
      {shell("kill -SEGV $$"), "was ended by signal 11, Segmentation fault"},
      {{"there/is/no/such"}, "ended with exit code 127: there is no such program"},
      {{"/etc/passwd"}, "ended with exit code 126: it cannot be run"},
      {shell("exec >&-; exec sleep 30"), "closed its standard output"}};
  for (const auto& [arguments, end] : ends) {
    LineProgram program(arguments);
    EXPECT_EQ(program.line(), std::nullopt);
    EXPECT_EQ(program.how_it_ended(), end);
  }
}

TEST(LineProgram, IsNoEndlessWaitWhereItsChildrenLiveOn) {
  EXPECT_THAT(all_lines("sleep 1000 2>/dev/null & echo one", {seconds(20), "it was started"}),
              ElementsAre("one"));
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

TEST(LineProgram, BoundsALineAndWhatIsWrittenWithoutReading) {
  LineProgram endless(shell("head -c 100000000 /dev/zero"));
  EXPECT_EQ(reason_of(endless), "a line of more than 4 MiB");
  LineProgram deaf({"yes"});
  const auto send_much = [&] {
    for (int k = 0; k < 100; ++k) deaf.send(std::string(1 << 20, 'x') + "\n");
  };
  EXPECT_THROW(send_much(), std::runtime_error);
}

TEST(LineProgram, IsReportedWhileItIsWaitedForNoLongerThanItIsTold) {
  std::vector<std::string> told;
  on_waiting([&told](const std::string& text) { told.push_back(text); });
  LineProgram silent(shell("exec sleep 30"));
  EXPECT_EQ(
      reason_of(silent, {seconds(1), "it was started"}),
      "wrote nothing for 1 s after it was started; no line received yet; are its lines flushed?");
  LineProgram program(shell("echo one; sleep 0.6; printf '\\033[31m\\n'; sleep 30 # \x1b[32m"));
  const Patience impatient{seconds(2), "it was asked", milliseconds(300)};
  EXPECT_THAT(program.line(impatient), Optional(std::string_view("one")));
  EXPECT_THAT(program.line(impatient), Optional(std::string_view("\x1b[31m")));
  const std::string waiting =
      "waiting for sh -c echo one; sleep 0.6; printf '\\033[31m\\n'; sleep 30 # \\x1b[32m; last "
      "line "
      "received: ";
  EXPECT_THAT(told, ElementsAre(waiting + "one", "")) << "and told when the wait is over";
  EXPECT_EQ(
      reason_of(program, impatient),
      "wrote nothing for 2 s after it was asked; last line received: \\x1b[31m; are its lines "
      "flushed?");
  EXPECT_EQ(told.back(), waiting + "\\x1b[31m") << "which is safe on a terminal";
  on_waiting({});
}

TEST(LineProgram, LeavesNothingBehindAWrapper) {
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

TEST(LineProgram, EndsWithItsObjectByItselfIfItDoes) {
  const auto how = fresh_folder() / "how";
  const auto pid_of = [&](const std::string& lines) {
    LineProgram program(shell("echo $$; " + lines));
    return std::stoi(std::string(*program.line()));
  };
  const std::string by_itself = "cat; echo ended > " + how.string();
  EXPECT_EQ(kill(pid_of(by_itself), 0), -1);
  EXPECT_EQ(text_of(how), "ended\n");
  EXPECT_EQ(kill(pid_of("while true; do sleep 0.1; done"), 0), -1) << "by force";
  fs::remove(how);
  auto first = std::make_unique<LineProgram>(shell(by_itself));
  const LineProgram second({"cat"});
  first.reset();
  EXPECT_EQ(text_of(how), "ended\n") << "the second does not hold the first one's input open";
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
  EXPECT_TRUE(holds_in_a_copy([&] {
    const bool is_ours = program->is_of_this_thread();
    const auto start = steady_clock::now();
    program.reset();
    return !is_ours && steady_clock::now() - start < milliseconds(900);
  }));
  program->send("still here\n");
  EXPECT_THAT(program->line(), Optional(std::string_view("still here")));
}

}  // namespace
}  // namespace ricochet::outside
