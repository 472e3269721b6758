#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/report/painted.h"

namespace ricochet::report {
namespace {

/// The value of a line at a position within it.
double value_at(const std::vector<Sample>& line, double position) {
  const auto right = std::find_if(line.begin() + 1, line.end() - 1, [&](const Sample& sample) {
    return sample.position >= position;
  });
  const auto left = right - 1;
  const double share = (position - left->position) / (right->position - left->position);
  return *left->value + share * (*right->value - *left->value);
}

TEST(Simplified, LeavesOutWhatLiesOnAStraightLine) {
  const auto corners = simplified({{0, 0}, {1, 1}, {2, 2}, {3, 1}, {4, 0}}, 1e-3, 1e-3);
  ASSERT_EQ(corners.size(), 3U);
  EXPECT_EQ(corners[1].position, 2);
}

TEST(Simplified, IsNowhereOffByMoreThanItMay) {
  std::vector<Sample> wave;
  for (int i = 0; i <= 1000; ++i) wave.push_back({i / 1e3, std::abs(std::sin(i / 50.0))});
  const double off = 0.01;
  const auto corners = simplified(wave, 1e-9, off);  // so narrow that only the value counts
  EXPECT_LT(corners.size(), 120U);
  EXPECT_GT(corners.size(), 20U);
  for (const Sample& sample : wave) {
    EXPECT_LE(std::abs(value_at(corners, sample.position) - *sample.value), 1.001 * off);
  }
}

TEST(Simplified, KeepsWhatIsShort) {
  EXPECT_TRUE(simplified({}, 1, 1).empty());
  EXPECT_EQ(simplified({{0, 1}}, 1, 1).size(), 1U);
  EXPECT_EQ(simplified({{0, 1}, {1, 1}}, 100, 100).size(), 2U);
}

TEST(Simplified, KeepsTheWayThereAndBack) {
  EXPECT_EQ(needed_corners({{0, 0}, {5, 0}, {0, 0}}, 0.1), (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace ricochet::report
