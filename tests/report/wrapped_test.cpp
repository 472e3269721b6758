#include <gmock/gmock.h>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TextWidth, IsThatOfABrowserWithTheWidestUsualFont) {
  // As Chromium draws them in DejaVu Sans of 12 pixels.
  EXPECT_NEAR(text_width("processor time per impact [s]"), 177.6, 1.8);
  EXPECT_NEAR(text_width("relative difference"), 109.3, 1.7);
  EXPECT_NEAR(text_width("pagmo-cmaes-tuned"), 124.7, 1.2);
  EXPECT_NEAR(text_width("1000"), 30.5, 0.5);
  EXPECT_NEAR(text_width("evaluations for each variable"), 174.7, 1.7);
  EXPECT_NEAR(text_width("border: the carrier starts to move"), 201.2, 2.0);
}

TEST(TextWidth, CountsCharactersAndNotBytes) {
  EXPECT_EQ(text_width("ωω"), 2 * text_width("ω"));
  EXPECT_EQ(text_width("ω"), text_width("é"));
  EXPECT_EQ(text_width("abc", 24), 2 * text_width("abc"));
}

TEST(Shortened, IsTheTextWhereItHasRoom) {
  EXPECT_EQ(shortened("speed", text_width("speed")), "speed");
}

TEST(Shortened, EndsBetweenCharactersWithAnEllipsis) {
  EXPECT_EQ(shortened("ωωωωωω", text_width("ωωω…")), "ωωω…");
  EXPECT_EQ(shortened("abcdef", 5), "…");
}

TEST(Wrapped, BreaksAtSpaces) {
  EXPECT_THAT(wrapped("one two three", text_width("one two")), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one  two", 100), ElementsAre("one  two"));
  EXPECT_THAT(wrapped("incomprehensible word", 56), ElementsAre("incomprehensible", "word"));
  EXPECT_THAT(wrapped("", 100), IsEmpty());
}

}  // namespace
}  // namespace ricochet::report
