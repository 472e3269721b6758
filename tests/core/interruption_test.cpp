#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "src/core/progress.h"

namespace ricochet {
namespace {

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

TEST(Interruption, EndsTheProgramTidily) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const char* said = "^whole\nfirst\nsecond\nricochet: interrupted; go on so\n$";
  EXPECT_EXIT(interrupt_itself(SIGINT), testing::ExitedWithCode(130), said);
  EXPECT_EXIT(interrupt_itself(SIGTERM), testing::ExitedWithCode(143), said);
}

TEST(Interruption, ThatReachesTheProgramAndItsGroupIsOne) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_DFL);
        end_tidily_when_interrupted();
        kill(getpid(), SIGINT);
        usleep(10'000);
        kill(getpid(), SIGINT);
        sleep(10);
      },
      testing::ExitedWithCode(130), "^ricochet: interrupted\n$");
}

TEST(Interruption, ThatIsIgnoredStaysIgnored) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        end_tidily_when_interrupted();
        kill(getpid(), SIGINT);
        usleep(100'000);
        std::exit(7);
      },
      testing::ExitedWithCode(7), "^$");
}

}  // namespace
}  // namespace ricochet
