#include "src/studies/best_values/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/studies/best_values/some_questions.h"

namespace ricochet::studies::best_values {
namespace {

TEST(Search, OfSeveralVariablesFindsTheConstrainedOptimum) {
  const Question question{.stated = cut_bowl(), .penalty_weight = 10};
  const BestKnown best = best_of(question, Effort{400, 0});
  EXPECT_NEAR(best.value, 2.0, 1e-6);
  EXPECT_NEAR(best.point[0], 0, 1e-3);
  EXPECT_LE(best.point.sum(), 1.0);
  EXPECT_NE(best.provenance.find("seed"), std::string::npos);
}

TEST(Search, FindsTheSameAgain) {
  const Question question{.stated = cut_bowl(), .penalty_weight = 10};
  const Effort effort{100, 0};
  const BestKnown once = best_of(question, effort);
  const BestKnown again = best_of(question, effort);
  EXPECT_EQ(once.value, again.value);
  EXPECT_EQ(once.point, again.point);
  EXPECT_EQ(once.provenance, again.provenance);
}

TEST(Search, ScansOneVariableByTheStepOfItsQuestion) {
  Question question{stairs()};
  EXPECT_NE(best_of(question, {}).provenance.find("step 0.001"), std::string::npos);
  question.scan_step = 0.01;
  EXPECT_NE(best_of(question, {}).provenance.find("step 0.01"), std::string::npos);
}

TEST(Search, SmoothsWhereItCan) {
  Problem steps = cut_bowl();
  steps.constraints = 0;
  steps.evaluate = [](const Vector& x) { return Values{std::ceil(x.squaredNorm()), {}}; };
  steps.differentiate = nullptr;
  std::vector<double> widths;
  steps.smoothed = [&widths, steps](double width) {
    widths.push_back(width);
    return steps;
  };
  best_of({steps}, Effort{100, 0});
  EXPECT_EQ(std::set<double>(widths.begin(), widths.end()), (std::set<double>{0.1, 0.25}));
}

}  // namespace
}  // namespace ricochet::studies::best_values
