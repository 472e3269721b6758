#include "src/research/calibration/variants/speed_restitution.h"

#include <gtest/gtest.h>

namespace ricochet::studies::variants {
namespace {

TEST(SpeedRestitution, FallsWithTheFifthRootOfTheSpeed) {
  EXPECT_DOUBLE_EQ(speed_restitution(0.9, 0.1, 0.1), 0.9);
  EXPECT_EQ(speed_restitution(0.9, 0, 0.1), 1);
  EXPECT_DOUBLE_EQ(speed_restitution(0.9, 3.2, 0.1), 0.8) << "32 times the speed, twice the loss";
  EXPECT_EQ(speed_restitution(0.1, 3.2, 0.1), 0);
}

}  // namespace
}  // namespace ricochet::studies::variants
