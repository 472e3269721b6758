#include "src/core/open_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "src/core/text_file.h"

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

TEST_F(OpenFiles, AreAllowedAsFarAsTheSystemDoes) {
  allow_open_files(20);
  EXPECT_EQ(allowed(), 30U);
  allow_open_files(70);
  EXPECT_EQ(allowed(), 70U);
}

TEST_F(OpenFiles, AreRefusedBeyondTheLimitOfTheSystem) {
  const int too_many = static_cast<int>(before_.rlim_max) + 1;
  EXPECT_THAT([&] { allow_open_files(too_many); },
              testing::ThrowsMessage<OutputError>(fmt::format(
                  "too many open files: the limit is 30; raise it with ulimit -n {}", too_many)));
  EXPECT_EQ(allowed(), 30U);
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
