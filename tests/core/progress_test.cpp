#include "src/core/progress.h"

#include <unistd.h>

#include <csignal>

#include "ricochet/evaluator.h"
#include "src/core/in_parallel.h"
#include "src/core/time_limit.h"
#include "tests/support/numbers.h"
#include "tests/support/pipe.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

TEST(Progress, IsSilentWhereStandardErrorIsNoTerminal) {
  CaptureStderr();
  {
    Progress progress("counting", 3);
    for (int i = 0; i < 3; ++i) progress.advance(1);
  }
  EXPECT_EQ(GetCapturedStderr(), "");
}

TEST(Progress, AnnouncesALineThatIsSafeOnATerminal) {
  CaptureStderr();
  Progress::announce("starts \x1b[31m\nsh");
  EXPECT_EQ(GetCapturedStderr(), "starts \\x1b[31m\\x0ash\n");
}

TEST(Progress, FitsIntoANarrowTerminal) {
  if (!has_terminals()) GTEST_SKIP() << "there is no /dev/pts";
  const auto shown = [](unsigned short columns) {
    return shown_on_terminal([] { Progress progress("searching best values", 1); }, columns);
  };
  EXPECT_NE(shown(80).find("[   "), std::string::npos);
  EXPECT_NE(shown(0).find("[   "), std::string::npos) << "of unknown width";
  EXPECT_EQ(shown(40), "\r\033[Ksearching best values 0 %  0.0 s\r\n");
  EXPECT_EQ(shown(20), "\r\033[Ksearching best valu\r\n");
}

TEST(Warning, IsWrittenOnceForEachTextAndSteersNoTerminal) {
  CaptureStderr();
  for (const char* text :
       {"a.toml: count.slowest is now called counting_limit",
        "b.toml: count.slowest is now called counting_limit",
        "a.toml: count.slowest is now called counting_limit", "a\x1b[31m.toml: too long"}) {
    warn(text);
  }
  EXPECT_EQ(GetCapturedStderr(),
            "warning: a.toml: count.slowest is now called counting_limit\n"
            "warning: b.toml: count.slowest is now called counting_limit\n"
            "warning: a\\x1b[31m.toml: too long\n");
}

/// Interrupts itself, in a process of its own, and waits for what comes of it.
[[noreturn]] void interrupt_itself(int signal) {
  std::signal(signal, SIG_DFL);  // a shell's background jobs ignore some, and so would this one
  const AtInterruption first([] { std::fputs("second\n", stderr); }, "go on so");
  const AtInterruption last([] { std::fputs("first\n", stderr); });
  {
    const AtInterruption over([] { std::fputs("never\n", stderr); });
  }
  end_tidily_when_interrupted();
  {
    const Uninterrupted whole;
    kill(getpid(), signal);
    usleep(100'000);
    std::fputs("whole\n", stderr);
  }
  sleep(10);
  std::exit(0);
}

/// As a terminal does, which sends the signal to the program and to its group.
[[noreturn]] void interrupt_itself_twice(sighandler_t treated_before) {
  std::signal(SIGINT, treated_before);
  end_tidily_when_interrupted();
  for (int time = 0; time < 2; ++time) {
    kill(getpid(), SIGINT);
    usleep(10'000);
  }
  if (treated_before == SIG_DFL) sleep(10);
  usleep(100'000);
  std::exit(7);
}

TEST(Interruption, EndsTheProgramTidilyUnlessItIsIgnored) {
  // Starts the program anew, where no other thread has begun.
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const char* said = "^whole\nfirst\nsecond\nricochet: interrupted; go on so\n$";
  EXPECT_EXIT(interrupt_itself(SIGINT), testing::ExitedWithCode(130), said);
  EXPECT_EXIT(interrupt_itself(SIGTERM), testing::ExitedWithCode(143), said);
  EXPECT_EXIT(interrupt_itself_twice(SIG_DFL), testing::ExitedWithCode(130),
              "^ricochet: interrupted\n$");
  EXPECT_EXIT(interrupt_itself_twice(SIG_IGN), testing::ExitedWithCode(7), "^$");
}

/// Checks as often as it takes to look at the clock.
void check_for_long() {
  for (int i = 0; i < 1000; ++i) check_time_limit();
}

TEST(TimeLimit, EndsWorkWhenItIsReached) {
  EXPECT_NO_THROW(check_for_long());
  {
    TimeLimit limit(1e-9);
    EXPECT_TRUE(limit.is_reached());
    EXPECT_THROW(check_for_long(), TimeLimitReached);
    std::thread([] { EXPECT_NO_THROW(check_for_long()); }).join();
    const TimeLimit inner(infinity);
    EXPECT_THROW(check_for_long(), TimeLimitReached) << "the first to end holds";
  }
  EXPECT_NO_THROW(check_for_long()) << "it has ended";
  const TimeLimit long_one(infinity);
  EXPECT_NO_THROW(check_for_long());
}

TEST(TimeLimit, HoldsForSharedWork) {
  const TimeLimit limit(1e-9);
  EXPECT_THROW(in_parallel("work", 100, [](std::size_t) { check_for_long(); }), TimeLimitReached);
  std::atomic<int> stopped = 0;
  in_parallel("work", 100, [&](std::size_t) {
    try {
      check_for_long();
    } catch (const TimeLimitReached&) {
      ++stopped;
    }
  });
  EXPECT_EQ(stopped, 100);
}

TEST(TimeLimit, KnowsHowFarTheWorkIs) {
  const TimeLimit limit(infinity);
  EXPECT_EQ(limit.stage(), nullptr);
  report_progress("first", 0.25);
  EXPECT_EQ(limit.stage(), std::string("first"));
  EXPECT_EQ(limit.share(), 0.25);
  std::atomic<std::size_t> sum = 0;
  in_parallel("second", 10, [&](std::size_t i) {
    report_progress("part", 0.5);
    sum += i;
  });
  EXPECT_EQ(sum, 45U) << "each once";
  EXPECT_EQ(limit.stage(), std::string("second"));
  EXPECT_EQ(limit.share(), 1);
}

/// Keeps the processor busy for so long [s].
void work(double seconds) {
  const double end = processor_seconds() + seconds;
  while (processor_seconds() < end) {
  }
}

TEST(Stopwatch, TellsTheTimeOfThisThreadWithoutWhatIsToBeLeftOut) {
  Stopwatch stopwatch;
  stopwatch.leave_out([] { work(0.02); });
  EXPECT_LT(stopwatch.read(), 0.01);
  work(0.01);
  EXPECT_GE(stopwatch.read(), 0.01);
}

TEST(Stopwatch, GlancesCatchUpWithinSixtyFour) {
  Stopwatch stopwatch;
  work(1e-3);
  EXPECT_GE(stopwatch.glance(), 1e-3) << "the first glance reads";
  for (int i = 0; i < 100'000; ++i) ASSERT_GE(stopwatch.glance(), 0);
  const double before = stopwatch.read();
  work(1e-3);
  int glances = 0;
  while (stopwatch.glance() <= before) ASSERT_LT(++glances, 64);
  EXPECT_GE(stopwatch.glance(), before + 1e-3);
}

}  // namespace
}  // namespace ricochet
