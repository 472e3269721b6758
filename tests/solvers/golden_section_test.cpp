#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(GoldenSection, ShrinksTheIntervalByItsRatioAtEveryPoint) {
  // After the first few the interval is 200 * 0.618^k at most.
  const RunRecord record = run(sphere(1, 3), golden_section(), {30}, 0);
  EXPECT_NEAR(record.trace.back().x[0], 3, 1e-2);
}

TEST(GoldenSection, HandsOverTheBestPointWhereTheIntervalIsShort) {
  const RunRecord record = run(sphere(1, 3), golden_section(), {60}, 0);
  EXPECT_EQ(record.terminations.front().reason, "the interval is short");
  EXPECT_NEAR(record.returned->x[0], 3, 1e-4);
}

TEST(GoldenSection, TakesOneVariableWithoutConstraints) {
  EXPECT_TRUE(golden_section().accepts(staircase()));
  EXPECT_FALSE(golden_section().accepts(sphere(2, 3)));
  EXPECT_FALSE(golden_section().accepts(limited(7)));
}

}  // namespace
}  // namespace ricochet
