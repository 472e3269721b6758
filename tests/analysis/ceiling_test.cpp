#include <gtest/gtest.h>

#include "src/analysis/results.h"
#include "tests/analysis/valley.h"

namespace ricochet::comparison {
namespace {

TEST(Ceiling, IsTheTrueValuesAtTheOptimumOfTheSurrogate) {
  const auto found = ceiling(valley_problem(), 0.125);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->optimum, 0.625, 1e-4);
  EXPECT_NEAR(found->distance, 0.125, 1e-4);
  EXPECT_NEAR(found->optimality_gap.value_or(-1), 0.125, 1e-4);
}

TEST(Ceiling, HasNoOptimalityGapWhereTheOptimumIsTrulyInfeasible) {
  Problem problem = valley_problem();
  problem.true_values = [](const Vector& x) { return TrueValues{0, x[0] > 0.6 ? 1.0 : 0.0}; };
  problem.smoothed = [true_values = problem.true_values](double smoothing) {
    Problem smooth = valley(smoothing);
    smooth.true_values = true_values;
    return smooth;
  };
  EXPECT_FALSE(ceiling(problem, 0.25)->optimality_gap);
}

TEST(Ceiling, IsOfOneVariableWithASurrogate) {
  Problem problem = valley_problem();
  problem.smoothed = nullptr;
  EXPECT_FALSE(ceiling(problem, 0.25));
}

}  // namespace
}  // namespace ricochet::comparison
