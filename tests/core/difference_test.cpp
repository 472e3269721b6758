#include "src/core/difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet {
namespace {

TEST(Difference, IsExactToManyDigitsOfASmoothFunction) {
  for (const double x : {0.3, 1.0, 2.5}) {
    const Difference slope = difference([](double t) { return std::sin(t); }, x, 0.1);
    EXPECT_NEAR(slope.slope, std::cos(x), 1e-12);
    EXPECT_LT(slope.error, 1e-11);
  }
}

TEST(Difference, OwnsUpToAnErrorNextToACorner) {
  // The first step leads over the corner at 0 and the last does not.
  const Difference slope = difference([](double t) { return std::abs(t); }, 0.03, 0.1);
  EXPECT_NEAR(slope.slope, 1.0, 1e-9);
  // None is short enough.
  const Difference none = difference([](double t) { return std::abs(t); }, 1e-6, 0.1);
  EXPECT_LT(none.slope, 0.5);
}

TEST(Extrapolation, RemovesTheSquareOfTheStep) {
  Extrapolation<> extrapolation;
  extrapolation.add(3 + 7 * 1.0);
  EXPECT_TRUE(std::isinf(extrapolation.best().error));
  extrapolation.add(3 + 7 * 0.25);
  EXPECT_DOUBLE_EQ(extrapolation.best().slope, 3);
}

TEST(Extrapolation, RemovesTheStepItselfFromDifferencesToOneSide) {
  const Difference slope = one_sided_difference([](double t) { return t * t + t; }, 2.0, 0.5);
  EXPECT_NEAR(slope.slope, 5, 1e-13);
}

TEST(Difference, IsThatOfEveryEntryOfAVector) {
  const auto f = [](double t) -> Vector { return Eigen::Vector2d(std::sin(t), std::exp(t)); };
  const std::vector<Difference> slopes = differences(f, 0.3, 0.1);
  ASSERT_EQ(slopes.size(), 2U);
  EXPECT_NEAR(slopes[0].slope, std::cos(0.3), 1e-12);
  EXPECT_NEAR(slopes[1].slope, std::exp(0.3), 1e-12);
}

}  // namespace
}  // namespace ricochet
