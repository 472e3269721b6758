#include "src/site/rounded.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet::site {
namespace {

TEST(Rounded, KeepsFiveDigitsOfANumberAndWholeNumbersAsTheyAre) {
  EXPECT_EQ(rounded(1.0 / 3).dump(), "0.33333");
  EXPECT_EQ(rounded(1234567), 1234567);
  EXPECT_EQ(rounded(2e-9 / 3), 6.6667e-10);
}

TEST(Rounded, HasNothingForWhatIsNoFiniteNumber) {
  EXPECT_TRUE(rounded(nullptr).is_null());
  EXPECT_TRUE(rounded(std::numeric_limits<double>::infinity()).is_null());
  EXPECT_TRUE(rounded("1").is_null());
}

}  // namespace
}  // namespace ricochet::site
