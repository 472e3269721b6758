#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "src/core/child_process.h"

namespace ricochet {
namespace {

std::string called(const std::function<std::string()>& work, std::chrono::seconds limit) {
  return called_in_isolation(work, limit, 200);
}

std::string failure_of(const std::function<std::string()>& work, int seconds = 20) {
  try {
    return "returned " + called(work, std::chrono::seconds(seconds));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(IsolatedCall, ReturnsTheText) {
  EXPECT_EQ(called([] { return ""; }, std::chrono::seconds(20)), "");
  const std::string much(1 << 20, 'x');
  EXPECT_EQ(called([&] { return much; }, std::chrono::seconds(20)), much);
}

TEST(IsolatedCall, ChangesNothingHere) {
  int here = 1;
  EXPECT_EQ(called([&] { return std::to_string(++here); }, std::chrono::seconds(20)), "2");
  EXPECT_EQ(here, 1);
}

TEST(IsolatedCall, SaysHowItFailed) {
  EXPECT_EQ(failure_of([]() -> std::string { throw std::runtime_error("torn"); }), "torn");
  EXPECT_EQ(failure_of([]() -> std::string { throw 7; }), "threw what is no std::exception");
  EXPECT_EQ(failure_of([]() -> std::string { _exit(3); }), "ended the process, with exit status 3");
  EXPECT_EQ(failure_of([]() -> std::string {
              std::signal(SIGBUS, SIG_DFL);
              raise(SIGBUS);
              return "";
            }),
            "crashed: Bus error");
  EXPECT_EQ(failure_of(
                []() -> std::string {
                  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
                },
                1),
            "took more than 1 s");
}

TEST(IsolatedCall, DoesNotWaitForWhatTheCallHasStarted) {
  EXPECT_EQ(called(
                [] {
                  if (fork() == 0) std::this_thread::sleep_for(std::chrono::hours(1));
                  return "here";
                },
                std::chrono::seconds(20)),
            "here");
}

}  // namespace
}  // namespace ricochet
