#include "src/studies/best_values/search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/best_values/some_questions.h"

namespace ricochet::studies::best_values {
namespace {

TEST(Search, ScansForTheFirstOfTheLowest) {
  const BestKnown best = scan_for_best(stairs(), 0.001);
  EXPECT_EQ(best.value, -3);
  EXPECT_EQ(best.point[0], 2.0);
  EXPECT_NE(best.provenance.find("0.001"), std::string::npos);
}

TEST(Search, BisectsToTheEdgeOfWhatIsFeasible) {
  const BestKnown best = scan_for_best(speeds(), 0.01);
  EXPECT_LE(best.point[0], 3.14159265);
  EXPECT_NEAR(best.point[0], 3.14159265, 1e-7);
  EXPECT_EQ(best.value, -best.point[0]);
}

TEST(Search, SaysThatNothingIsFeasible) {
  Problem problem = speeds();
  problem.evaluate = [](const Vector& x) { return Values{-x[0], Vector::Constant(1, 1.0)}; };
  const BestKnown best = scan_for_best(problem, 0.01);
  EXPECT_TRUE(std::isinf(best.value));
  EXPECT_EQ(best.point.size(), 0);
}

TEST(Search, OfSeveralVariablesFindsTheConstrainedOptimum) {
  const Question question{"cut-bowl", {cut_bowl()}};
  const BestKnown best = best_of(question, Effort{1e-3, 1e-2, 400, 0});
  EXPECT_NEAR(best.value, 2.0, 1e-6);
  EXPECT_NEAR(best.point[0], 0, 1e-3);
  EXPECT_LE(best.point.sum(), 1.0);
  EXPECT_NE(best.provenance.find("seed"), std::string::npos);
}

TEST(Search, FindsTheSameAgain) {
  const Question question{"cut-bowl", {cut_bowl()}};
  const Effort effort{1e-3, 1e-2, 100, 0};
  const BestKnown once = best_of(question, effort);
  const BestKnown again = best_of(question, effort);
  EXPECT_EQ(once.value, again.value);
  EXPECT_EQ(once.point, again.point);
  EXPECT_EQ(once.provenance, again.provenance);
}

TEST(Search, TakesOneVariableForAScanAndRobustOnesForACoarserOne) {
  Question question{"stairs", {stairs()}};
  EXPECT_NE(best_of(question, {}).provenance.find("step 0.001"), std::string::npos);
  question.name = "robust-mean-C1";
  EXPECT_NE(best_of(question, {}).provenance.find("step 0.01"), std::string::npos);
}

}  // namespace
}  // namespace ricochet::studies::best_values
