#include <gtest/gtest.h>

#include "problems/carrier_track/counting/staircase.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track {
namespace {

TEST(QuietIntervals, AreTheStretchesOfQuietSpeeds) {
  const SpeedScan scan{0.5, {2, 3, 4, 5, 3, 9, 1, 1, 1}};
  const auto found = quiet_intervals(scan, 3);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].from, 0.5);
  EXPECT_EQ(found[0].to, 1.0);
  EXPECT_EQ(found[1].from, 2.5);
  EXPECT_EQ(found[1].width(), 0.0);
  EXPECT_EQ(found[2].from, 3.5);
  EXPECT_EQ(found[2].to, 4.5);
}

TEST(QuietIntervals, AreNoneWhereAllIsLoudAndOneWhereAllIsQuiet) {
  const SpeedScan scan{0.5, {4, 5}};
  EXPECT_TRUE(quiet_intervals(scan, 3.5).empty());
  EXPECT_EQ(quiet_intervals(scan, 5).size(), 1U);
}

}  // namespace
}  // namespace ricochet::carrier_track
