#include <gmock/gmock.h>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TextWidth, CountsCharactersAndNotBytes) {
  EXPECT_EQ(text_width("ω²"), 14);
  EXPECT_EQ(text_width("abc", 24), 42);
}

TEST(Shortened, IsTheTextWhereItHasRoom) {
  EXPECT_EQ(shortened("speed", 35), "speed");
}

TEST(Shortened, EndsBetweenCharactersWithAnEllipsis) {
  EXPECT_EQ(shortened("ωωωωωω", 28), "ωωω…");
  EXPECT_EQ(shortened("abcdef", 5), "…");
}

TEST(Wrapped, BreaksAtSpaces) {
  EXPECT_THAT(wrapped("one two three", 7 * 8), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one  two", 100), ElementsAre("one  two"));
  EXPECT_THAT(wrapped("incomprehensible word", 7 * 8), ElementsAre("incompr…", "word"));
  EXPECT_THAT(wrapped("", 100), IsEmpty());
}

}  // namespace
}  // namespace ricochet::report
