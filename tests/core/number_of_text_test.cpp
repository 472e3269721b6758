#include <gtest/gtest.h>

#include <cstdint>

#include "src/core/names.h"

namespace ricochet {
namespace {

TEST(NumberOfText, ReadsTheWholeText) {
  EXPECT_EQ(number_of_text<int>("17"), 17);
  EXPECT_EQ(number_of_text<int>("-3"), -3);
  EXPECT_EQ(number_of_text<double>("1e-3"), 1e-3);
  EXPECT_EQ(number_of_text<std::int64_t>("9007199254740993"), 9007199254740993);
}

TEST(NumberOfText, HasNothingForAnythingElse) {
  for (const char* text : {"", " 1", "1 ", "1a", "1.5", "+1", "0x1", "99999999999"}) {
    EXPECT_EQ(number_of_text<int>(text), std::nullopt) << text;
  }
  EXPECT_EQ(number_of_text<unsigned>("-1"), std::nullopt);
}

}  // namespace
}  // namespace ricochet
