#include "ricochet/run.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "src/core/instance.h"
#include "src/studies/fireworks/study.h"
#include "tests/support/test.h"

namespace ricochet::studies::fireworks {
namespace {

TEST(Cec2013, FunctionsAreNowhereBelowZero) {
  Random random(1);
  for (unsigned number = 1; number <= 28; ++number) {
    const Problem problem = cec2013(number, 10);
    for (int k = 0; k < 200; ++k)
      ASSERT_GT(problem.evaluate(uniform_point(problem, random)).objective, 0) << number;
  }
  EXPECT_THROW(cec2013(29, 10), std::invalid_argument);
  EXPECT_THROW(cec2013(1, 7), std::invalid_argument) << "there is no such dimension";
}

TEST(Cec2013, FunctionsComeNearZero) {
  // In two dimensions the best is found, and so tells whether what is taken off is the best value.
  const Solver solver = ricochet::fireworks::bare_bones_fireworks("bbfwa", {.sparks = 30});
  for (const unsigned number : {1U, 6U, 11U, 12U, 14U, 17U}) {
    double best = 1e9;
    for (int run_number = 1; run_number <= 10; ++run_number) {
      const RunRecord record = run(cec2013(number, 2), solver, {20'000}, run_number);
      best = std::min(best, record.trace.back().true_values.objective);
    }
    EXPECT_GE(best, -1e-9) << number;
    EXPECT_LT(best, 1e-6) << number;
  }
}

}  // namespace
}  // namespace ricochet::studies::fireworks
