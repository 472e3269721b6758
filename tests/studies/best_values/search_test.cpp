#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "src/studies/best_values/best_values.h"
#include "tests/studies/best_values/some_problems.h"

namespace ricochet::studies::best_values {
namespace {

TEST(Search, OfSeveralVariablesFindsTheConstrainedOptimum) {
  Problem problem = cut_bowl();
  problem.penalty_weight = 10;
  const BestKnown best = best_of(problem, Effort{200});
  EXPECT_NEAR(best.value, 2.0, 1e-6);
  EXPECT_NEAR(best.point[0], 0, 1e-3);
  EXPECT_LE(best.point.sum(), 1 + constraint_tolerance);
  EXPECT_NE(best.provenance.find("seed"), std::string::npos);
}

TEST(Search, FindsTheSameAgain) {
  Problem problem = cut_bowl();
  problem.penalty_weight = 10;
  const Effort effort{50};
  const BestKnown once = best_of(problem, effort);
  const BestKnown again = best_of(problem, effort);
  EXPECT_EQ(once.value, again.value);
  EXPECT_EQ(once.point, again.point);
  EXPECT_EQ(once.provenance, again.provenance);
}

TEST(Search, ScansOneVariableByTheStepOfItsProblem) {
  Problem problem{stairs()};
  EXPECT_NE(best_of(problem, {}).provenance.find("step 0.001"), std::string::npos);
  problem.scan_step = 0.01;
  EXPECT_NE(best_of(problem, {}).provenance.find("step 0.01"), std::string::npos);
}

/// Stairs up from the middle of the box, with a surrogate.
Problem steps() {
  Problem steps = cut_bowl();
  steps.constraints = 0;
  steps.tolerance = 0.5;
  steps.smoothing = 0.3;
  steps.evaluate = [](const Vector& x) { return Values{std::ceil(x.squaredNorm()), {}}; };
  steps.differentiate = nullptr;
  return steps;
}

TEST(Search, ImprovesOnTheSurrogateToo) {
  Problem problem = steps();
  std::set<double> smoothings;
  problem.smoothed = [&smoothings, smooth = problem](double smoothing) {
    smoothings.insert(smoothing);
    return smooth;
  };
  best_of(problem, Effort{50});
  EXPECT_TRUE(smoothings.contains(0.3));
}

TEST(Search, EndsWhereTwoAgreeAndSaysSo) {
  EXPECT_NE(best_of(steps(), Effort{200}).provenance.find("; 2 of 2 searches of 400 evaluations"),
            std::string::npos);
}

TEST(Search, KeepsABestPointThatNoSearchFinds) {
  Problem needle = steps();
  const Vector x = Vector::Constant(2, 3.21);
  needle.evaluate = [x, others = needle.evaluate](const Vector& at) {
    return at == x ? Values{-9, {}} : others(at);
  };
  needle.best_point = x;
  needle.best_known = -9;
  needle.provenance = "by hand; 2 of 3 searches of 7 evaluations agree";
  const BestKnown best = best_of(needle, Effort{50, 1});
  EXPECT_EQ(best.value, -9);
  EXPECT_EQ(best.point, x);
  EXPECT_EQ(best.provenance, "by hand; 0 of 3 searches of 100 evaluations agree");
}

}  // namespace
}  // namespace ricochet::studies::best_values
