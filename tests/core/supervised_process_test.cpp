#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>

#include "src/core/process.h"

namespace ricochet {
namespace {

/// A pipe whose end tells that no process holds its other end any more.
class Held {
 public:
  Held() { EXPECT_EQ(pipe(ends_), 0); }
  ~Held() {
    close(ends_[0]);
    let_go();
  }
  void let_go() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  /// Waits for that end.
  bool by_nobody() {
    let_go();
    char byte = 0;
    return read(ends_[0], &byte, 1) == 0;
  }

 private:
  int ends_[2] = {-1, -1};
};

void sleep_long() {
  std::this_thread::sleep_for(std::chrono::hours(1));
}

/// Starts a process that only its supervisor can find again: of another session, and an orphan.
void start_hidden() {
  if (fork() == 0) {
    setsid();
    if (fork() == 0) sleep_long();
    _exit(0);
  }
  wait(nullptr);
}

/// A child that stops its supervisor, once or again and again, hangs nobody.
TEST(SupervisedProcess, EndsThoughItsSupervisorIsStopped) {
  for (const bool again : {false, true}) {
    const auto start = std::chrono::steady_clock::now();
    Held held;
    {
      SupervisedProcess process([&] {
        do {
          kill(getppid(), SIGSTOP);
        } while (again);
        sleep_long();
      });
      EXPECT_FALSE(process.ends_within(300));
      process.end();
    }
    EXPECT_TRUE(held.by_nobody());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << again;
  }
}

std::string ending_of(const std::function<void()>& work) {
  SupervisedProcess process(work);
  EXPECT_TRUE(process.ends_within(20'000));
  return ending_in_words(process.end());
}

TEST(SupervisedProcess, EndsAsItsChildDoes) {
  EXPECT_EQ(ending_of([] { _exit(0); }), "ended the process, with exit status 0");
  EXPECT_EQ(ending_of([] { _exit(3); }), "ended the process, with exit status 3");
  EXPECT_EQ(ending_of([] {}), "ended the process, with exit status 1") << "it returned";
  EXPECT_EQ(ending_of([] { kill(getpid(), SIGKILL); }), "crashed: Killed");
  EXPECT_EQ(ending_of([] {
              std::signal(SIGSEGV, SIG_DFL);
              kill(getpid(), SIGSEGV);
            }),
            "crashed: Segmentation fault");
}

TEST(SupervisedProcess, IsKilledWhenAskedWithAllThatItHasStarted) {
  for (int time = 0; time < 5; ++time) {
    Held held;
    SupervisedProcess process([] {
      start_hidden();
      start_hidden();
      sleep_long();
    });
    EXPECT_FALSE(process.ends_within(time * 10));
    EXPECT_EQ(ending_in_words(process.end()), "crashed: Killed");
    EXPECT_TRUE(held.by_nobody());
  }
}

TEST(SupervisedProcess, LeavesNoOrphansWhenItsChildEnds) {
  Held held;
  SupervisedProcess process([] {
    start_hidden();
    _exit(0);
  });
  EXPECT_TRUE(process.ends_within(20'000));
  EXPECT_TRUE(held.by_nobody());
}

TEST(SupervisedProcess, EndsWithItsOwnerHoweverThatEnds) {
  for (const int signal : {0, SIGKILL, SIGTERM, SIGSEGV}) {
    Held held;
    const pid_t owner = fork();
    if (owner == 0) {
      std::signal(SIGSEGV, SIG_DFL);
      const SupervisedProcess process([] {
        start_hidden();
        sleep_long();
      });
      if (signal == 0) _exit(0);
      kill(getpid(), signal);
      sleep_long();
    }
    waitpid(owner, nullptr, 0);
    EXPECT_TRUE(held.by_nobody()) << signal;
  }
}

TEST(SupervisedProcess, LosesItsChildOnlyWhereTheSupervisorIsKilled) {
  Held held;
  SupervisedProcess process([] {
    kill(getppid(), SIGKILL);
    sleep_long();
  });
  EXPECT_TRUE(process.ends_within(20'000));
  EXPECT_TRUE(held.by_nobody());
}

TEST(SupervisedProcess, IsLeftAloneByACopyOfItsOwner) {
  SupervisedProcess process(sleep_long);
  const pid_t copy = fork();
  if (copy == 0) {
    process.~SupervisedProcess();
    _exit(0);
  }
  waitpid(copy, nullptr, 0);
  EXPECT_FALSE(process.ends_within(100));
}

}  // namespace
}  // namespace ricochet
