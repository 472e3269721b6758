#include <gtest/gtest.h>

#include "src/core/names.h"

namespace ricochet {
namespace {

TEST(OneLine, LeavesTextAsItIs) {
  EXPECT_EQ(one_line("a.toml: Größe = 3: must be > 0"), "a.toml: Größe = 3: must be > 0");
}

TEST(OneLine, EscapesWhatSteersATerminal) {
  EXPECT_EQ(one_line("a\nb\x1b[31m\x7f"), "a\\x0ab\\x1b[31m\\x7f");
  EXPECT_EQ(one_line("\xc2\x9b"
                     "31m"),
            "\\xc2\\x9b31m");  // the same in one character
  EXPECT_EQ(one_line("\xff\xc3"), "\\xff\\xc3");
}

TEST(OneLine, EscapesWhatReordersALine) {
  EXPECT_EQ(one_line("a\u202eb\u2066\u200f"), "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6\\xe2\\x80\\x8f");
  EXPECT_EQ(one_line("\u061c\u2028"), "\\xd8\\x9c\\xe2\\x80\\xa8");
  EXPECT_EQ(one_line("\u200e\u2069"), "\\xe2\\x80\\x8e\\xe2\\x81\\xa9") << "the first and the last";
  EXPECT_EQ(one_line("\u200d\u2010\u2065\u206a"), "\u200d\u2010\u2065\u206a") << "just beside them";
}

TEST(OneLine, LeavesTheMiddleOfALongTextOut) {
  const std::string line = one_line("start" + std::string(10'000'000, 'x') + "end");
  EXPECT_LT(line.size(), 5000U);
  EXPECT_TRUE(line.starts_with("start") && line.ends_with("end"));
}

}  // namespace
}  // namespace ricochet
