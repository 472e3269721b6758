#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "src/core/time_limit.h"
#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

constexpr int calls = 20'000;

void expect_share(int count, double probability) {
  EXPECT_NEAR(count, probability * calls, 5 * std::sqrt(probability * (1 - probability) * calls));
}

TEST(NotANumber, IsATwentiethOfAllFunctionsEachWithItsSlopes) {
  Random random(1);
  const Problem problem = random_problem(random, {.constraints = 2});
  const Problem told = not_a_number().perturbed(problem, 1);
  const Vector& x = problem.start;
  int objectives = 0, constraints = 0, both = 0, gradients = 0, residuals = 0, hessians = 0;
  for (int k = 0; k < calls; ++k) {
    const Values values = told.evaluate(x);
    objectives += std::isnan(values.objective);
    constraints += std::isnan(values.constraints[1]);
    both += std::isnan(values.objective) && std::isnan(values.constraints[1]);
    const Derivatives d = told.differentiate(x);
    gradients += std::isnan(d.values.objective);
    EXPECT_EQ(std::isnan(d.values.objective), d.gradient.array().isNaN().all());
    EXPECT_EQ(std::isnan(d.values.objective), d.gradient.array().isNaN().any());
    for (Eigen::Index j = 0; j < 2; ++j) {
      EXPECT_EQ(std::isnan(d.values.constraints[j]), d.jacobian.row(j).array().isNaN().all());
      EXPECT_EQ(std::isnan(d.values.constraints[j]), d.jacobian.row(j).array().isNaN().any());
    }
    const Residuals r = told.residuals(x);
    residuals += std::isnan(r.values[0]);
    EXPECT_EQ(r.values.array().isNaN().all(), r.jacobian.array().isNaN().any());
    const Matrix hessian = told.lagrangian_hessian(x, 1, Vector::Zero(2));
    hessians += hessian.array().isNaN().all();
  }
  for (const int count : {objectives, constraints, gradients, residuals, hessians}) {
    expect_share(count, 0.05);
  }
  expect_share(both, 0.0025);
}

TEST(NotANumber, LeavesTheOtherValuesAsTheyAre) {
  for (const Problem& problem : random_problems()) {
    const Problem told = not_a_number().perturbed(problem, 1);
    for (int k = 0; k < 100; ++k) {
      const double value = told.evaluate(problem.start).objective;
      EXPECT_TRUE(std::isnan(value) || value == problem.evaluate(problem.start).objective);
    }
  }
}

TEST(Throwing, ThrowsOnceInAThousandCallsOfAnyKind) {
  Random random(1);
  const Problem problem = random_problem(random, {.constraints = 1});
  const Problem told = throwing().perturbed(problem, 3);
  const Vector& x = problem.start;
  const std::vector<std::function<void()>> ways = {
      [&] { EXPECT_EQ(told.evaluate(x).objective, problem.evaluate(x).objective); },
      [&] { EXPECT_EQ(told.differentiate(x).gradient, problem.differentiate(x).gradient); },
      [&] { EXPECT_EQ(told.residuals(x).values, problem.residuals(x).values); },
      [&] { told.lagrangian_hessian(x, 1, Vector::Zero(1)); }};
  for (const auto& way : ways) {
    int thrown = 0;
    for (int k = 0; k < calls; ++k) {
      try {
        way();
      } catch (const std::runtime_error&) {
        ++thrown;
      }
    }
    expect_share(thrown, 1e-3);
  }
  for (int k = 0; k < calls; ++k) EXPECT_NO_THROW(told.true_values(x));
}

TEST(Throwing, EndsARunWithWhatWasFoundBefore) {
  Random random(1);
  const Problem told = throwing().perturbed(random_problem(random, {}), 3);
  Scorer scorer(told);
  Evaluator evaluator(told, {calls}, &scorer);
  while (!evaluator.over()) evaluator.values(uniform_point(told, random));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
  EXPECT_GT(evaluator.ledger().charged, 0);
  EXPECT_TRUE(scorer.best());
}

TEST(Slow, TakesATenthOfAMillisecondOfProcessorTimeMore) {
  const Problem problem = random_problems().front();
  const Problem told = slow().perturbed(problem, 0);
  const Vector& x = problem.start;
  const std::vector<std::function<void()>> ways = {
      [&] { EXPECT_EQ(told.evaluate(x).objective, problem.evaluate(x).objective); },
      [&] { told.differentiate(x); }, [&] { told.residuals(x); },
      [&] { told.lagrangian_hessian(x, 1, Vector()); }};
  for (const auto& way : ways) {
    const double before = processor_seconds();
    for (int k = 0; k < 10; ++k) way();
    EXPECT_GE(processor_seconds() - before, 1e-3);
  }
  Evaluator evaluator(told, {1'000'000, 0.01});
  while (!evaluator.over()) evaluator.values(x);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::seconds);
  EXPECT_LE(evaluator.ledger().charged, 100 + 64)
      << "a glance at the clock is 64 calls old at most";
}

}  // namespace
}  // namespace ricochet
