#include "src/core/process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "src/core/child_process.h"
#include "src/core/files.h"
#include "tests/support/pipe.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

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
    Pipe held;
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
    EXPECT_TRUE(held.is_held_by_nobody());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << again;
  }
}

TEST(SupervisedProcess, BeginsThoughItsSupervisorIsStoppedAtOnce) {
  for (int trial = 0; trial < 100; ++trial) {
    SupervisedProcess process([] {
      kill(getppid(), SIGSTOP);
      sleep_long();
    });
    EXPECT_EQ(ending_in_words(process.end()), "crashed: Killed");
  }
}

[[noreturn]] void crash_by(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
  std::abort();
}

TEST(SupervisedProcess, EndsAsItsChildDoesAndLeavesNoOrphans) {
  const std::pair<std::function<void()>, std::string> endings[] = {
      {[] { _exit(0); }, "ended the process, with exit status 0"},
      {[] { _exit(3); }, "ended the process, with exit status 3"},
      {[] {}, "ended the process, with exit status 1"},
      {[] { kill(getpid(), SIGKILL); }, "crashed: Killed"},
      {[] { crash_by(SIGSEGV); }, "crashed: Segmentation fault"}};
  for (const auto& [work, ending] : endings) {
    Pipe held;
    SupervisedProcess process([&work = work] {
      start_hidden();
      work();
    });
    EXPECT_TRUE(process.ends_within(20'000));
    EXPECT_TRUE(held.is_held_by_nobody());
    EXPECT_EQ(ending_in_words(process.end()), ending);
  }
}

TEST(SupervisedProcess, IsKilledWhenAskedWithAllThatItHasStarted) {
  for (int time = 0; time < 5; ++time) {
    Pipe held;
    SupervisedProcess process([] {
      start_hidden();
      start_hidden();
      sleep_long();
    });
    EXPECT_FALSE(process.ends_within(time * 10));
    EXPECT_EQ(ending_in_words(process.end()), "crashed: Killed");
    EXPECT_TRUE(held.is_held_by_nobody());
  }
}

TEST(SupervisedProcess, EndsWithItsOwnerHoweverThatEnds) {
  for (const int signal : {0, SIGKILL, SIGTERM, SIGSEGV}) {
    Pipe held;
    const pid_t owner = fork();
    if (owner == 0) {
      const SupervisedProcess process([] {
        start_hidden();
        sleep_long();
      });
      if (signal == 0) _exit(0);
      crash_by(signal);
    }
    waitpid(owner, nullptr, 0);
    EXPECT_TRUE(held.is_held_by_nobody()) << signal;
  }
}

TEST(SupervisedProcess, LosesItsChildOnlyWhereTheSupervisorIsKilled) {
  Pipe held;
  SupervisedProcess process([] {
    kill(getppid(), SIGKILL);
    sleep_long();
  });
  EXPECT_TRUE(process.ends_within(20'000));
  EXPECT_TRUE(held.is_held_by_nobody());
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

TEST(ResourceLimits, LeaveNoCoreFileAndBoundedMemory) {
  const pid_t child = fork();
  if (child == 0) {
    rlimit before{}, core{}, memory{};
    getrlimit(RLIMIT_AS, &before);
    limit_resources(100);
    getrlimit(RLIMIT_CORE, &core);
    getrlimit(RLIMIT_AS, &memory);
    if (core.rlim_cur != 0) _exit(1);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
    if (memory.rlim_cur >= before.rlim_cur || memory.rlim_cur < 100'000'000) _exit(2);
#endif
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

void allow_open_files(rlim_t now, rlim_t ever) {
  const rlimit limit{now, ever};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
}

int allowed_open_files() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<int>(limit.rlim_cur);
}

/// The limit with which so many further files may be open: descriptors 0 to 2 are, and maybe
/// others.
int limit_for(int further) {
  int limit = 0;
  for (int free = 0; free < further; ++limit) free += fcntl(limit, F_GETFD) < 0 ? 1 : 0;
  return limit;
}

/// Ends this process with 7 if 50 files are refused, with the reason, and nothing is changed.
[[noreturn]] void ask_beyond_the_limit() {
  allow_open_files(30, 40);
  const std::string reason = fmt::format(
      "too many open files: the limit is 30; raise it with ulimit -n {}", limit_for(50));
  const bool refused =
      complaint_of<OutputError>([] { return allow_further_open_files(50), 0; }) == reason;
  std::_Exit(refused && allowed_open_files() == 30 ? 7 : 8);
}

TEST(OpenFiles, AreAllowedBesidesThoseThatAreOpenAsFarAsTheSystemDoes) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  allow_open_files(30, before.rlim_max);
  allow_further_open_files(10);
  EXPECT_EQ(allowed_open_files(), 30);
  const int limit = limit_for(70);
  EXPECT_GE(limit, 73);
  std::vector<int> open;
  for (int k = 0; k <= 5; ++k) {
    allow_further_open_files(70);
    EXPECT_EQ(allowed_open_files(), limit + k);
    open.push_back(dup(STDERR_FILENO));
  }
  for (const int each : open) close(each);
  EXPECT_EXIT(ask_beyond_the_limit(), testing::ExitedWithCode(7), "");
  allow_open_files(before.rlim_cur, before.rlim_max);
}

TEST(Descriptor, LeadsNowhere) {
  Pipe pipe;
  lead_nowhere(pipe.read_end());
  lead_nowhere(pipe.write_end());
  EXPECT_EQ(write(pipe.write_end(), "lost", 4), 4);
  char nothing = 0;
  EXPECT_EQ(read(pipe.read_end(), &nothing, 1), 0);
}

TEST(Waiting, IsToldOnStandardErrorAndToWhoeverListens) {
  std::vector<std::string> told;
  on_waiting([&told](const std::string& text) { told.push_back(text); });
  testing::internal::CaptureStderr();
  tell_waiting("waiting for mine");
  tell_waiting("");
  on_waiting({});
  tell_waiting("again");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "waiting for mine\nagain\n");
  EXPECT_THAT(told, ElementsAre("waiting for mine", ""));
}

TEST(Frame, IsReadAsItWasWrittenWhateverItsLength) {
  Pipe pipe;
  std::mt19937_64 random(1);
  std::vector<std::string> messages = {"", std::string(1, '\0'), std::string(1'000'000, 'x')};
  for (int k = 0; k < 200; ++k) {
    std::string message(random() % 10'000, ' ');
    for (char& c : message) c = static_cast<char>(random());
    messages.push_back(message);
  }
  std::thread writer([&] {
    for (const std::string& message : messages) EXPECT_TRUE(write_frame(pipe.write_end(), message));
    pipe.stop_writing();
  });
  for (const std::string& message : messages) EXPECT_EQ(read_frame(pipe.read_end()), message);
  EXPECT_EQ(read_frame(pipe.read_end()), std::nullopt);
  writer.join();
}

TEST(Frame, IsNoneWhereItEndsWithinOrIsTooLongOrNobodyReads) {
  using namespace std::string_literals;
  for (const std::string& bytes : {"\5\0\0"s, "\5\0\0\0\0\0\0\0abcd"s, std::string(8, '\xFF')}) {
    Pipe pipe;
    pipe.put(bytes);
    pipe.stop_writing();
    EXPECT_EQ(read_frame(pipe.read_end()), std::nullopt);
  }
  Pipe pipe;
  pipe.stop_reading();
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_FALSE(write_frame(pipe.write_end(), "a"));
  std::signal(SIGPIPE, before);
}

TEST(Frame, IsTakenFromPiecesOfAnyLength) {
  Pipe pipe;
  FrameReader reader;
  const std::string two = std::string("\3\0\0\0\0\0\0\0abc", 11) + std::string(8, '\0');
  for (const char byte : two.substr(0, 10)) {
    pipe.put(std::string_view(&byte, 1));
    EXPECT_TRUE(reader.read_from(pipe.read_end()));
    EXPECT_EQ(reader.next(), std::nullopt);
  }
  pipe.put(two.substr(10));
  EXPECT_TRUE(reader.read_from(pipe.read_end()));
  EXPECT_EQ(reader.next(), "abc");
  EXPECT_EQ(reader.next(), "");
  EXPECT_EQ(reader.next(), std::nullopt);
  pipe.put(std::string(8, '\xff'));
  EXPECT_FALSE(reader.read_from(pipe.read_end())) << "no message has that length";
}

TEST(ChildProcess, AnswersUntilItIsToldOrEnded) {
  ChildProcess child([](int descriptor) {
    while (const auto message = read_frame(descriptor)) write_frame(descriptor, *message + "!");
    _exit(7);
  });
  for (const std::string& message : {std::string("a"), std::string(300'000, 'b')}) {
    ASSERT_TRUE(child.tell(message));
    EXPECT_EQ(child.hear(), message + "!");
  }
  EXPECT_FALSE(child.has_news(std::chrono::steady_clock::now() + std::chrono::milliseconds(20)));
  EXPECT_EQ(WEXITSTATUS(child.finish()), 7);
  EXPECT_EQ(child.hear(), std::nullopt);
  EXPECT_FALSE(child.tell("a"));
  ChildProcess asked([](int) { sleep_long(); });
  EXPECT_EQ(WTERMSIG(asked.end()), SIGKILL);
}

std::string called(const std::function<std::string()>& work, int seconds = 20) {
  return called_in_isolation(work, std::chrono::seconds(seconds), 200);
}

TEST(IsolatedCall, ReturnsTheTextAndChangesNothingHere) {
  for (const std::string& text : {std::string(), std::string(1 << 20, 'x')}) {
    EXPECT_EQ(called([&] { return text; }), text);
  }
  const auto starts_another = [] {
    if (fork() == 0) sleep_long();
    return "here";
  };
  EXPECT_EQ(called(starts_another), "here") << "it does not wait for that";
  int here = 1;
  EXPECT_EQ(called([&] { return std::to_string(++here); }), "2");
  EXPECT_EQ(here, 1);
}

TEST(IsolatedCall, SaysHowItFailed) {
  const auto failure_of = [](const std::function<std::string()>& work, int seconds = 20) {
    return complaint_of<std::runtime_error>([&] { return called(work, seconds); });
  };
  EXPECT_EQ(failure_of([]() -> std::string { throw std::runtime_error("torn"); }), "torn");
  EXPECT_EQ(failure_of([]() -> std::string { throw 7; }), "threw what is no std::exception");
  EXPECT_EQ(failure_of([]() -> std::string { _exit(3); }), "ended the process, with exit status 3");
  EXPECT_EQ(failure_of([]() -> std::string { crash_by(SIGBUS); }), "crashed: Bus error");
  EXPECT_EQ(failure_of([] { return sleep_long(), ""; }, 1), "took more than 1 s");
}

}  // namespace
}  // namespace ricochet
