#include "src/core/progress.h"

#include <gtest/gtest.h>

namespace ricochet {
namespace {

TEST(Progress, IsSilentWhereStandardErrorIsNoTerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress("counting", 3);
    for (int i = 0; i < 3; ++i) progress.advance(1);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, AnnouncesALineThatIsSafeOnATerminal) {
  testing::internal::CaptureStderr();
  Progress::announce("starts \x1b[31m\nsh");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "starts \\x1b[31m\\x0ash\n");
}

}  // namespace
}  // namespace ricochet
