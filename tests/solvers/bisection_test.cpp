#include <gtest/gtest.h>

#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "src/core/instance.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(Bisection, HalvesTheIntervalThatHoldsTheLimit) {
  // Both ends, then the start, then 18 / 2^k.
  const RunRecord record = run(limited(7), bisection(), {2 + 1 + 12}, 0);
  EXPECT_NEAR(record.trace.back().true_values.objective, -7, 18 / 4096.0);
  EXPECT_LE(record.trace.back().true_values.violation, 0);
}

TEST(Bisection, HandsOverAFeasiblePointAtTheLimit) {
  const RunRecord record = run(limited(7), bisection(), {40}, 0);
  ASSERT_TRUE(record.returned);
  EXPECT_NEAR(record.returned->x[0], 7, 1e-6);
  EXPECT_LE(record.returned->true_values.violation, 0);
}

TEST(Bisection, FindsItInABoxThatIsReflected) {
  Problem problem = limited(7);
  problem.best_point = Vector::Constant(1, 7);
  for (int number = 1; number <= 10; ++number) {
    const RunRecord record = run(instance(problem, number), bisection(), {40}, 0);
    EXPECT_NEAR(record.trace.back().true_values.objective, -7, 1e-5) << number;
  }
}

TEST(Bisection, TakesOneVariableWithALimit) {
  EXPECT_TRUE(bisection().accepts(limited(7)));
  EXPECT_FALSE(bisection().accepts(staircase()));
  EXPECT_FALSE(bisection().accepts(disc()));
}

}  // namespace
}  // namespace ricochet
