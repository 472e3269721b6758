#include <gtest/gtest.h>

#include "src/experiment/campaign.h"
#include "tests/analysis/valley.h"

namespace ricochet {
namespace {

using comparison::valley;

TEST(RelocatedOptimum, DiffersInWhereTheBestPointLies) {
  for (const double smoothing : {0.0, 0.25}) {
    const Problem problem = valley(smoothing);
    const Problem low = relocated(problem, OptimumPlace::lower_end, 1);
    EXPECT_EQ(low.lower[0], 0.5);
    EXPECT_EQ(low.upper[0], 1.0);
    const Problem high = relocated(problem, OptimumPlace::upper_end, 1);
    EXPECT_EQ(high.lower[0], 0.0);
    EXPECT_EQ(high.upper[0], 0.5);
    const Problem middle = relocated(problem, OptimumPlace::middle, 1);
    EXPECT_EQ(middle.lower[0] + middle.upper[0], 1.0);
    for (const Problem& each : {low, middle, high}) {
      EXPECT_EQ(true_values_at(each, *each.best_point).objective, 0);
      EXPECT_GE(each.start[0], each.lower[0]);
      EXPECT_LE(each.start[0], each.upper[0]);
      EXPECT_EQ(each.smoothed(0.125).lower, each.lower);
    }
  }
}

TEST(RelocatedOptimum, DrawsAStartForEveryNumber) {
  const Problem problem = valley(0);
  EXPECT_NE(relocated(problem, OptimumPlace::middle, 1).start,
            relocated(problem, OptimumPlace::middle, 2).start);
  EXPECT_EQ(relocated(problem, OptimumPlace::middle, 1).start,
            relocated(problem, OptimumPlace::middle, 1).start);
}

TEST(RelocatedOptimum, NeedsABestPointAtNoEnd) {
  Problem problem = valley(0);
  EXPECT_TRUE(can_be_relocated(problem));
  problem.best_point = problem.upper;
  EXPECT_FALSE(can_be_relocated(problem));
  problem.best_point.reset();
  EXPECT_FALSE(can_be_relocated(problem));
}

TEST(RelocatedOptimum, HasANameForEachPlace) {
  ASSERT_EQ(names_of_places().size(), 3U);
  EXPECT_EQ(place_named(names_of_places()[0]), OptimumPlace::lower_end);
  EXPECT_EQ(place_named("optimum-at-upper-end"), OptimumPlace::upper_end);
  EXPECT_FALSE(place_named("plain"));
}

}  // namespace
}  // namespace ricochet
