#include <gtest/gtest.h>

#include <numeric>

#include "ricochet/problem.h"
#include "src/studies/surrogate/derivative_check.h"

namespace ricochet::studies::surrogate {
namespace {

const GradientDoubtStudy& study() {
  static const GradientDoubtStudy made =
      study_gradient_doubt({6, 4, {0.25, 1e-7}, {1e-4, 1e-6, 1e-8}});
  return made;
}

TEST(GradientDoubt, CountsEveryPointOnce) {
  ASSERT_EQ(study().rows.size(), 12U);
  for (const CaseQuality& row : study().rows) {
    ASSERT_EQ(row.cells.size(), 6U);
    for (const GradientQuality& v : row.cells) {
      EXPECT_EQ(v.points, 4);
      EXPECT_EQ(std::accumulate(v.doubts.begin(), v.doubts.end(), 0), 4);
      EXPECT_LE(v.right, v.trending);
      EXPECT_LE(v.trending, v.points);
    }
  }
  EXPECT_EQ(study().by_smoothing[0].points, 12 * 6 * 4);
}

TEST(GradientDoubt, FindsTheDerivativesRightWhereTheyAreNotFlat) {
  const GradientQuality& usual = study().by_smoothing[0];
  const int flat = usual.doubts[static_cast<std::size_t>(GradientDoubt::flat)];
  EXPECT_GE(usual.agreeing + flat, 0.97 * usual.points);
  EXPECT_LT(flat, 0.2 * usual.points);
}

TEST(GradientDoubt, FindsNearlyEverythingFlatNextToTheCount) {
  const GradientQuality& narrow = study().by_smoothing[1];
  EXPECT_GT(narrow.doubts[static_cast<std::size_t>(GradientDoubt::flat)], 0.95 * narrow.points);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
