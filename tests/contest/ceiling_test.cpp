#include "src/contest/ceiling.h"

#include <gtest/gtest.h>

#include "tests/contest/valley.h"

namespace ricochet::contest {
namespace {

TEST(Ceiling, IsTheTruthAtTheOptimumOfTheSurrogate) {
  const auto found = ceiling(valley_question(), 0.125);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->optimum, 0.625, 1e-4);
  EXPECT_NEAR(found->distance, 0.125, 1e-4);
  EXPECT_NEAR(found->regret.value_or(-1), 0.125, 1e-4);
}

TEST(Ceiling, HasNoRegretWhereTheOptimumIsTrulyInfeasible) {
  Question question = valley_question();
  question.stated.truth = [](const Vector& x) { return Truth{0, x[0] > 0.6 ? 1.0 : 0.0}; };
  question.stated.smoothed = [truth = question.stated.truth](double width) {
    Problem problem = valley(width);
    problem.truth = truth;
    return problem;
  };
  EXPECT_FALSE(ceiling(question, 0.25)->regret);
}

TEST(Ceiling, IsOfOneVariableWithASurrogate) {
  Question question = valley_question();
  question.stated.smoothed = nullptr;
  EXPECT_FALSE(ceiling(question, 0.25));
}

}  // namespace
}  // namespace ricochet::contest
