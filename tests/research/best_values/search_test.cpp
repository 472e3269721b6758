#include "src/research/best_values/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/research/best_values/some_problems.h"

namespace ricochet::studies::best_values {
namespace {

TEST(Search, OfSeveralVariablesFindsTheConstrainedOptimum) {
  Problem problem = cut_bowl();
  problem.penalty_weight = 10;
  const BestKnown best = best_of(problem, Effort{400, 0});
  EXPECT_NEAR(best.value, 2.0, 1e-6);
  EXPECT_NEAR(best.point[0], 0, 1e-3);
  EXPECT_LE(best.point.sum(), 1.0);
  EXPECT_NE(best.provenance.find("seed"), std::string::npos);
}

TEST(Search, FindsTheSameAgain) {
  Problem problem = cut_bowl();
  problem.penalty_weight = 10;
  const Effort effort{100, 0};
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

TEST(Search, SmoothsWhereItCan) {
  Problem steps = cut_bowl();
  steps.constraints = 0;
  steps.evaluate = [](const Vector& x) { return Values{std::ceil(x.squaredNorm()), {}}; };
  steps.differentiate = nullptr;
  std::vector<double> smoothings;
  steps.smoothed = [&smoothings, steps](double smoothing) {
    smoothings.push_back(smoothing);
    return steps;
  };
  best_of({steps}, Effort{100, 0});
  EXPECT_EQ(std::set<double>(smoothings.begin(), smoothings.end()), (std::set<double>{0.1, 0.25}));
}

}  // namespace
}  // namespace ricochet::studies::best_values
