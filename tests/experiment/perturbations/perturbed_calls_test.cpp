#include <gtest/gtest.h>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// Adds 1 to whatever the objective is.
class OneMore : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    told.objective += 1;
    return told;
  }
};

TEST(PerturbedCalls, PassesOnWhatItDoesNothingAbout) {
  for (const Problem& problem : random_problems()) {
    const Problem same = perturbed_by(std::make_shared<OneMore>(), problem);
    const Vector& x = problem.start;
    EXPECT_EQ(same.evaluate(x).objective, problem.evaluate(x).objective + 1);
    EXPECT_EQ(same.evaluate(x).constraints, problem.evaluate(x).constraints);
    EXPECT_EQ(same.differentiate(x).gradient, problem.differentiate(x).gradient);
    EXPECT_EQ(same.residuals(x).values, problem.residuals(x).values);
    const Vector multipliers = Vector::Ones(problem.constraints);
    EXPECT_EQ(same.lagrangian_hessian(x, 2, multipliers),
              problem.lagrangian_hessian(x, 2, multipliers));
    EXPECT_EQ(same.true_values(x).objective, true_values_at(problem, x).objective);
    EXPECT_EQ(same.smoothed(0.5).evaluate(x).objective,
              problem.smoothed(0.5).evaluate(x).objective + 1);
  }
}

TEST(PerturbedCalls, HasNoFunctionsThatTheProblemHasNot) {
  Problem problem = random_problems().front();
  problem.differentiate = nullptr;
  problem.residuals = nullptr;
  problem.lagrangian_hessian = nullptr;
  problem.smoothed = nullptr;
  const Problem same = perturbed_by(std::make_shared<OneMore>(), problem);
  EXPECT_FALSE(same.differentiate);
  EXPECT_FALSE(same.residuals);
  EXPECT_FALSE(same.lagrangian_hessian);
  EXPECT_FALSE(same.smoothed);
}

TEST(PerturbedCalls, ComputesNothingTwiceWhereWhatIsShownIsTheTrueValues) {
  Random random(1);
  Problem problem = random_problem(random, {});
  int calls = 0;
  problem.evaluate = [&calls, evaluate = problem.evaluate](const Vector& x) {
    ++calls;
    return evaluate(x);
  };
  problem.differentiate = [&calls, differentiate = problem.differentiate](const Vector& x) {
    ++calls;
    return differentiate(x);
  };
  const Problem shown = perturbed_by(std::make_shared<OneMore>(), problem);
  Scorer scorer(shown);
  Evaluator evaluator(shown, {1000}, &scorer);
  for (int k = 0; k < 10; ++k) evaluator.values(uniform_point(problem, random));
  EXPECT_EQ(calls, 10);
  evaluator.derivatives(uniform_point(problem, random));
  EXPECT_EQ(calls, 11);
  evaluator.residuals(uniform_point(problem, random));
  EXPECT_EQ(calls, 12) << "for the scorer, which has not been told the values";
}

}  // namespace
}  // namespace ricochet
