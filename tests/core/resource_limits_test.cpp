#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "src/core/process.h"

namespace ricochet {
namespace {

TEST(ResourceLimits, LeaveNoCoreFileAndBoundedMemory) {
  const pid_t child = fork();
  if (child == 0) {
    rlimit before{};
    getrlimit(RLIMIT_AS, &before);
    limit_resources(100);
    rlimit core{};
    rlimit memory{};
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

}  // namespace
}  // namespace ricochet
