#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/analysis/outcomes.h"
#include "tests/analysis/valley.h"

namespace ricochet::comparison {
namespace {

/// A count that is the same everywhere but at the best point.
Problem count_problem(double count, double best) {
  Problem problem = valley_problem();
  problem.tolerance = 0.5;
  problem.best_known = best;
  problem.true_values = [count](const Vector&) { return TrueValues{count, 0}; };
  return problem;
}

TEST(Targets, OfACountAreAllLevelsBelowThatOfARandomPoint) {
  EXPECT_EQ(targets_of(count_problem(7, 3)), (Targets{0.5, 1.5, 2.5, 3.5}));
  EXPECT_EQ(targets_of(count_problem(4, 3)), (Targets{0.5}));
  EXPECT_EQ(targets_of(count_problem(3, 3)), (Targets{0.5})) << "a random point solves it";
  EXPECT_EQ(targets_of(count_problem(203, 3)).size(), 200U);
}

TEST(Targets, OfOtherObjectivesAre51EvenOnALogarithmicScale) {
  const Problem problem = valley_problem();
  const Targets targets = targets_of(problem);
  ASSERT_EQ(targets.size(), 51U);
  EXPECT_EQ(targets.front(), problem.tolerance);
  EXPECT_DOUBLE_EQ(targets.back(), reference_gap(problem));
  // Of |x - 1/2| at a uniform point the median is 1/4.
  EXPECT_NEAR(targets.back(), 0.25, 0.15);
  const double ratio = targets[1] / targets[0];
  for (std::size_t k = 1; k < targets.size(); ++k) {
    EXPECT_NEAR(targets[k] / targets[k - 1], ratio, 1e-9 * ratio);
  }
}

TEST(Targets, AreTheSameEveryTime) {
  EXPECT_EQ(targets_of(valley_problem()), targets_of(valley_problem()));
}

TEST(Targets, AreTheToleranceAloneIfNothingIsKnownOfRandomPoints) {
  Problem problem = valley_problem();
  problem.true_values = [](const Vector&) -> TrueValues { throw std::runtime_error("no"); };
  EXPECT_EQ(targets_of(problem), (Targets{1e-9}));
  problem.true_values = [](const Vector&) {
    return TrueValues{std::numeric_limits<double>::quiet_NaN(), 0};
  };
  EXPECT_EQ(targets_of(problem), (Targets{1e-9}));
}

TEST(Targets, HaveAReferenceAmongFeasiblePointsIfThereAreAny) {
  Problem problem = valley_problem();
  problem.true_values = [](const Vector& x) {
    return TrueValues{x[0] < 0.5 ? 3.0 : 100.0, x[0] < 0.5 ? 0.0 : 1.0};
  };
  EXPECT_EQ(reference_gap(problem), 3);
  problem.true_values = [](const Vector&) { return TrueValues{-5, 1}; };
  EXPECT_EQ(reference_gap(problem), 5);
}

TEST(Targets, OfToleranceZeroAreFinite) {
  Problem problem = valley_problem();
  problem.tolerance = 0;
  const Targets targets = targets_of(problem);
  EXPECT_EQ(targets.front(), 0);
  EXPECT_TRUE(std::is_sorted(targets.begin(), targets.end()));
  EXPECT_TRUE(std::isfinite(targets.back()));
}

}  // namespace
}  // namespace ricochet::comparison
