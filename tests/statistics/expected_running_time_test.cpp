#include "src/statistics/expected_running_time.h"

#include <gtest/gtest.h>

namespace ricochet {
namespace {

TEST(ExpectedRunningTime, ChargesAFailedRunItsOwnLength) {
  // 20 + 100 + 60 evaluations for two successes.
  EXPECT_EQ(expected_running_time({{20, true}, {100, false}, {60, true}}), 90.0);
}

TEST(ExpectedRunningTime, IsNothingWithoutASuccess) {
  EXPECT_FALSE(expected_running_time({{20, false}}));
  EXPECT_FALSE(expected_running_time({}));
}

}  // namespace
}  // namespace ricochet
