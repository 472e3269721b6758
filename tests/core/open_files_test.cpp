#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "src/core/files.h"
#include "src/core/process.h"

namespace ricochet {
namespace {

/// At first the process may have 30 files open.
class OpenFiles : public testing::Test {
 protected:
  void SetUp() override {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit few{30, before_.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  }
  void TearDown() override { setrlimit(RLIMIT_NOFILE, &before_); }

  static rlim_t allowed() {
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    return limit.rlim_cur;
  }

  rlimit before_{};
};

/// The limit with which so many further files may be open: descriptors 0 to 2 are, and maybe
/// others.
int limit_for(int further) {
  int limit = 0;
  for (int free = 0; free < further; ++limit) free += fcntl(limit, F_GETFD) < 0 ? 1 : 0;
  return limit;
}

TEST_F(OpenFiles, AreAllowedAsFarAsTheSystemDoes) {
  allow_further_open_files(10);
  EXPECT_EQ(allowed(), 30U);
  allow_further_open_files(70);
  EXPECT_EQ(allowed(), static_cast<rlim_t>(limit_for(70)));
  EXPECT_GE(allowed(), 73U);
}

TEST_F(OpenFiles, AreCountedBesidesThoseThatAreOpen) {
  const int before = limit_for(70);
  std::vector<int> open;
  for (int k = 0; k < 5; ++k) open.push_back(dup(STDERR_FILENO));
  allow_further_open_files(70);
  EXPECT_EQ(allowed(), static_cast<rlim_t>(before + 5));
  for (const int each : open) close(each);
}

/// Ends this process with 7 if 50 files are refused, with the reason, and nothing is changed.
[[noreturn]] void ask_beyond_the_limit() {
  const rlimit hard{30, 40};
  setrlimit(RLIMIT_NOFILE, &hard);
  const std::string reason = fmt::format(
      "too many open files: the limit is 30; raise it with ulimit -n {}", limit_for(50));
  rlimit after{};
  try {
    allow_further_open_files(50);
  } catch (const OutputError& error) {
    getrlimit(RLIMIT_NOFILE, &after);
    std::_Exit(error.what() == reason && after.rlim_cur == 30U ? 7 : 8);
  }
  std::_Exit(9);
}

TEST_F(OpenFiles, AreRefusedBeyondTheLimitOfTheSystem) {
  EXPECT_EXIT(ask_beyond_the_limit(), testing::ExitedWithCode(7), "");
}

TEST(Descriptor, LeadsNowhere) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  for (const int end : ends) lead_nowhere(end);
  EXPECT_EQ(write(ends[1], "lost", 4), 4);
  char nothing = 0;
  EXPECT_EQ(read(ends[0], &nothing, 1), 0);
  for (const int end : ends) close(end);
}

}  // namespace
}  // namespace ricochet
