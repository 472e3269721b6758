#include "src/core/progress.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

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

/// What it shows on a terminal of so many columns.
std::string shown_on_terminal(unsigned short columns) {
  int ours = -1;
  int terminal = -1;
  const winsize size{24, columns, 0, 0};
  EXPECT_EQ(openpty(&ours, &terminal, nullptr, nullptr, &size), 0);
  const int standard_error = dup(STDERR_FILENO);
  dup2(terminal, STDERR_FILENO);
  { Progress progress("searching best values", 1); }
  dup2(standard_error, STDERR_FILENO);
  std::string shown(1000, '\0');
  shown.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ours, shown.data(), 1000))));
  for (const int each : {ours, terminal, standard_error}) close(each);
  return shown;
}

TEST(Progress, FitsIntoANarrowTerminal) {
  EXPECT_NE(shown_on_terminal(80).find("[   "), std::string::npos);
  EXPECT_NE(shown_on_terminal(0).find("[   "), std::string::npos) << "of unknown width";
  EXPECT_EQ(shown_on_terminal(40), "\r\033[Ksearching best values 0 %  0.0 s\r\n");
  EXPECT_EQ(shown_on_terminal(20), "\r\033[Ksearching best valu\r\n");
}

}  // namespace
}  // namespace ricochet
