#include "ricochet/problem.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet {
namespace {

double violation(const Vector& constraints, Eigen::Index equalities) {
  return true_values_of({0, constraints}, equalities).violation;
}

TEST(Problem, IsViolatedByItsLargestConstraint) {
  EXPECT_EQ(violation(Vector(0), 0), 0);
  EXPECT_EQ(violation(Vector{{-3, -1}}, 0), 0);
  EXPECT_EQ(violation(Vector{{-3, 2, 1}}, 0), 2);
}

TEST(Problem, IsViolatedByAnEqualityOfEitherSign) {
  EXPECT_EQ(violation(Vector{{-3, -1}}, 1), 3);
  EXPECT_EQ(violation(Vector{{3, -1}}, 1), 3);
  EXPECT_EQ(violation(Vector{{0, -1}}, 1), 0);
  EXPECT_EQ(violation(Vector{{-1, 4}}, 1), 4);
}

TEST(Problem, GrantsEveryConstraintTheSameTolerance) {
  for (const Eigen::Index equalities : {0, 1, 2}) {
    EXPECT_EQ(violation(Vector{{constraint_tolerance, constraint_tolerance}}, equalities), 0);
    EXPECT_EQ(violation(Vector{{2 * constraint_tolerance, 0}}, equalities),
              2 * constraint_tolerance);
    EXPECT_EQ(violation(Vector{{0, 2 * constraint_tolerance}}, equalities),
              2 * constraint_tolerance);
  }
  EXPECT_EQ(violation(Vector{{-constraint_tolerance, -1}}, 1), 0);
  EXPECT_GT(violation(Vector{{-2 * constraint_tolerance, -1}}, 1), 0);
  EXPECT_EQ(violation(Vector{{-2 * constraint_tolerance, -1}}, 0), 0);
}

TEST(Problem, IsNotFeasibleWhereAConstraintIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::Index equalities : {0, 1}) {
    EXPECT_TRUE(std::isnan(violation(Vector{{nan, 2}}, equalities)));
    EXPECT_TRUE(std::isnan(violation(Vector{{2, nan}}, equalities)));
  }
}

TEST(Problem, OfLessViolationIsBetterThenOneOfALowerObjective) {
  EXPECT_TRUE(better({5, 0}, {1, 1}));
  EXPECT_TRUE(better({1, 1}, {5, 1}));
  EXPECT_FALSE(better({1, 1}, {1, 1}));
}

}  // namespace
}  // namespace ricochet
