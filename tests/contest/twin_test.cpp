#include "src/contest/twin.h"

#include <gtest/gtest.h>

#include "tests/contest/valley.h"

namespace ricochet::contest {
namespace {

TEST(Twin, DiffersInWhereTheBestPointLies) {
  for (const double width : {0.0, 0.25}) {
    const Problem problem = valley(width);
    const Problem low = twin(problem, Place::lower_end, 1);
    EXPECT_EQ(low.lower[0], 0.5);
    EXPECT_EQ(low.upper[0], 1.0);
    const Problem high = twin(problem, Place::upper_end, 1);
    EXPECT_EQ(high.lower[0], 0.0);
    EXPECT_EQ(high.upper[0], 0.5);
    const Problem middle = twin(problem, Place::middle, 1);
    EXPECT_EQ(middle.lower[0] + middle.upper[0], 1.0);
    for (const Problem& each : {low, middle, high}) {
      EXPECT_EQ(truth_at(each, *each.best_point).objective, 0);
      EXPECT_GE(each.start[0], each.lower[0]);
      EXPECT_LE(each.start[0], each.upper[0]);
      EXPECT_EQ(each.smoothed(0.125).lower, each.lower);
    }
  }
}

TEST(Twin, DrawsAStartForEveryNumber) {
  const Problem problem = valley(0);
  EXPECT_NE(twin(problem, Place::middle, 1).start, twin(problem, Place::middle, 2).start);
  EXPECT_EQ(twin(problem, Place::middle, 1).start, twin(problem, Place::middle, 1).start);
}

TEST(Twin, IsThereWhereTheBestPointIsAtNoEnd) {
  Problem problem = valley(0);
  EXPECT_TRUE(has_twins(problem));
  problem.best_point = problem.upper;
  EXPECT_FALSE(has_twins(problem));
  problem.best_point.reset();
  EXPECT_FALSE(has_twins(problem));
}

}  // namespace
}  // namespace ricochet::contest
