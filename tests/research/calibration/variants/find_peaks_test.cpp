#include "src/research/calibration/variants/find_peaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ricochet::studies::variants {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(FindPeaks, TakesSamplesAboveBothNeighbours) {
  EXPECT_THAT(find_peaks({0, 1, 0, 2, -1, 3, 2}), ElementsAre(1, 3, 5));
  EXPECT_THAT(find_peaks({-3, -2, -5}), ElementsAre(1));
}

TEST(FindPeaks, NeverTakesAnEnd) {
  EXPECT_THAT(find_peaks({3, 2, 1, 2, 3}), IsEmpty());
  EXPECT_THAT(find_peaks({3, 3, 1, 3, 3}), IsEmpty());
  EXPECT_THAT(find_peaks({}), IsEmpty());
  EXPECT_THAT(find_peaks({1}), IsEmpty());
}

TEST(FindPeaks, TakesAPlateauOnceAtItsFirstSample) {
  EXPECT_THAT(find_peaks({0, 2, 2, 2, 1}), ElementsAre(1));
  EXPECT_THAT(find_peaks({0, 1, 1, 2, 2, 0}), ElementsAre(3)) << "a step on the way up is none";
  EXPECT_THAT(find_peaks({2, 1, 1, 0}), IsEmpty());
}

TEST(FindPeaks, KeepsTheHighestOfThoseThatAreTooClose) {
  const std::vector<double> samples = {0, 5, 0, 7, 0, 6, 0, 0, 0, 4, 0};
  EXPECT_THAT(find_peaks(samples, 0.5), ElementsAre(1, 3, 5, 9));
  EXPECT_THAT(find_peaks(samples, 2), ElementsAre(3, 9)) << "as far as the distance is too close";
  EXPECT_THAT(find_peaks(samples, 1.9), ElementsAre(1, 3, 5, 9));
  EXPECT_THAT(find_peaks(samples, 100), ElementsAre(3));
  // 7 removes 6, which therefore does not remove 5.
  EXPECT_THAT(find_peaks({0, 7, 0, 6, 0, 5, 0}, 3), ElementsAre(1, 5));
  EXPECT_THAT(find_peaks({0, 7, 0, 7, 0}, 3), ElementsAre(1)) << "of equals the first";
}

}  // namespace
}  // namespace ricochet::studies::variants
