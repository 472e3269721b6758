#include "src/statistics/sign_test.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <stdexcept>

namespace ricochet {
namespace {

TEST(SignTest, IsTheEnumerationOfAllSigns) {
  EXPECT_DOUBLE_EQ(sign_test(8, 2), 112.0 / 1024);  // 2 (1 + 10 + 45)
  EXPECT_EQ(sign_test(0, 0), 1);
  for (int pairs = 1; pairs <= 12; ++pairs) {
    for (int wins = 0; wins <= pairs; ++wins) {
      int as_far = 0;
      for (unsigned signs = 0; signs < 1U << pairs; ++signs) {
        as_far += std::abs(2 * std::popcount(signs) - pairs) >= std::abs(2 * wins - pairs) ? 1 : 0;
      }
      EXPECT_NEAR(sign_test(wins, pairs - wins), static_cast<double>(as_far) / (1 << pairs), 1e-12);
    }
  }
}

TEST(SignTest, RefusesNegativeCounts) {
  EXPECT_THROW(sign_test(-1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
