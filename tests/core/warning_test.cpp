#include <gtest/gtest.h>

#include "src/core/progress.h"

namespace ricochet {
namespace {

TEST(Warning, IsWrittenOnceForEachText) {
  testing::internal::CaptureStderr();
  warn("a.toml: count.slowest is now called counting_limit");
  warn("b.toml: count.slowest is now called counting_limit");
  warn("a.toml: count.slowest is now called counting_limit");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: a.toml: count.slowest is now called counting_limit\n"
            "warning: b.toml: count.slowest is now called counting_limit\n");
}

TEST(Warning, SteersNoTerminal) {
  testing::internal::CaptureStderr();
  warn("a\x1b[31m.toml: too long");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: a\\x1b[31m.toml: too long\n");
}

}  // namespace
}  // namespace ricochet
