// What the evaluator charges for residuals and second derivatives.

#include <gtest/gtest.h>

#include <stdexcept>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(Evaluator, ChargesOnePlusNForResidualsAndRemembersThem) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {100});
  const Vector x = Vector::Constant(3, 0.5);
  ASSERT_TRUE(evaluator.values(x));
  const auto first = evaluator.residuals(x);
  EXPECT_EQ(evaluator.ledger().charged, 1 + 4) << "values at this point make them no cheaper";
  EXPECT_EQ(evaluator.residuals(x, Part::jacobian)->values, first->values);
  EXPECT_EQ(evaluator.ledger().charged, 1 + 4);
  EXPECT_EQ(evaluator.ledger().derivatives, 1);
  EXPECT_EQ(evaluator.ledger().values, 1);
  ASSERT_TRUE(evaluator.residuals(Vector::Constant(3, 0.25)));
  EXPECT_EQ(evaluator.ledger().charged, 1 + 4 + 4);
  ASSERT_TRUE(evaluator.residuals(Vector::Constant(3, 0.25)));
  EXPECT_EQ(evaluator.ledger().charged, 1 + 4 + 4 + 4) << "who asks again pays again";
}

TEST(Evaluator, ChargesOneForResidualsAloneAndNForTheirDerivatives) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {10});
  const Vector x = Vector::Constant(3, 0.5), y = Vector::Constant(3, 0.25);
  EXPECT_EQ(*evaluator.residual_values(x, Part::nothing), problem.residuals(x).values);
  EXPECT_EQ(*evaluator.residual_values(x), problem.residuals(x).values);
  EXPECT_EQ(evaluator.ledger().charged, 1) << "paid for what is asked next";
  EXPECT_EQ(evaluator.residuals(x)->jacobian, problem.residuals(x).jacobian);
  EXPECT_EQ(evaluator.ledger().charged, 4);
  EXPECT_EQ(evaluator.ledger().derivatives, 1);
  ASSERT_TRUE(evaluator.residual_values(x));
  EXPECT_EQ(evaluator.ledger().charged, 5) << "who asks again pays again";
  ASSERT_TRUE(evaluator.residuals(y));
  EXPECT_EQ(evaluator.ledger().charged, 9);
  ASSERT_TRUE(evaluator.residual_values(x));
  EXPECT_FALSE(evaluator.residuals(x)) << "three more are not left";
  EXPECT_EQ(evaluator.ledger().charged, 10);
}

TEST(Evaluator, EvaluatesResidualsOutsideTheBoxAtTheProjection) {
  const Problem problem = parabola(1);
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  EXPECT_EQ(evaluator.residuals(Vector::Constant(1, 7.0))->values,
            problem.residuals(problem.upper).values);
  EXPECT_EQ(scorer.best()->x, problem.upper);
}

TEST(Evaluator, RefusesResidualsThatTheBudgetDoesNotCover) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {7});
  const Vector x = Vector::Constant(3, 0.5);
  ASSERT_TRUE(evaluator.residuals(x));
  EXPECT_FALSE(evaluator.residuals(Vector::Constant(3, 0.25)));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  EXPECT_EQ(evaluator.ledger().charged, 4);
  EXPECT_FALSE(evaluator.residuals(x)) << "not even what it remembers";
}

TEST(Evaluator, TakesResidualsThatDoNotFitForAFailure) {
  for (const Residuals& loss :
       {Residuals{Vector(0), Matrix(0, 2)}, Residuals{Vector::Ones(2), Matrix::Ones(3, 2)},
        Residuals{Vector::Ones(2), Matrix::Ones(2, 3)}}) {
    Problem problem = parabola(2);
    problem.residuals = [&loss](const Vector&) { return loss; };
    Evaluator evaluator(problem, {10});
    EXPECT_FALSE(evaluator.residuals(problem.start));
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
    EXPECT_THROW(std::rethrow_exception(evaluator.failure()), std::logic_error);
  }
  Problem problem = parabola(2);
  problem.residuals = nullptr;
  Evaluator evaluator(problem, {10});
  EXPECT_FALSE(evaluator.residuals(problem.start));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
}

/// parabola(n) with second derivatives.
Problem curved_parabola(Eigen::Index n) {
  Problem problem = parabola(n);
  problem.lagrangian_hessian = [n](const Vector&, double factor, const Vector&) -> Matrix {
    return 2 * factor * Matrix::Identity(n, n);
  };
  return problem;
}

TEST(Evaluator, ChargesAHessianForEachOfItsOwnEntries) {
  const Problem problem = curved_parabola(3);
  Evaluator evaluator(problem, {100});
  const Vector x = Vector::Constant(3, 0.5);
  ASSERT_TRUE(evaluator.derivatives(x));
  EXPECT_EQ(evaluator.lagrangian_hessian(x, 1.5, Vector()), 3 * Matrix::Identity(3, 3));
  EXPECT_EQ(evaluator.ledger().charged, 4 + 6);
  EXPECT_EQ(evaluator.ledger().hessians, 1);
  ASSERT_TRUE(evaluator.values(x));
  EXPECT_EQ(evaluator.ledger().charged, 4 + 6) << "what was known of the point still is";
  ASSERT_TRUE(evaluator.lagrangian_hessian(x, 1.5, Vector()));
  EXPECT_EQ(evaluator.ledger().charged, 4 + 6 + 6) << "who asks again pays again";
}

TEST(Evaluator, ScoresThePointOfAHessian) {
  const Problem problem = curved_parabola(2);
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  ASSERT_TRUE(evaluator.lagrangian_hessian(Vector::Constant(2, 7.0), 1, Vector()));
  EXPECT_EQ(scorer.best()->x, problem.upper);
  EXPECT_EQ(scorer.best()->evaluations, 3);
  EXPECT_EQ(evaluator.ledger().values, 0);
}

TEST(Evaluator, RefusesAHessianThatTheBudgetDoesNotCover) {
  const Problem problem = curved_parabola(3);
  Evaluator evaluator(problem, {5});
  EXPECT_FALSE(evaluator.lagrangian_hessian(problem.start, 1, Vector()));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  EXPECT_EQ(evaluator.ledger().charged, 0);
}

TEST(Evaluator, TakesAHessianThatDoesNotFitOrIsNotThereForAFailure) {
  Problem problem = curved_parabola(2);
  for (const Matrix& loss : {Matrix(0, 2), Matrix(2, 3)}) {
    problem.lagrangian_hessian = [&loss](const Vector&, double, const Vector&) { return loss; };
    Evaluator evaluator(problem, {10});
    EXPECT_FALSE(evaluator.lagrangian_hessian(problem.start, 1, Vector()));
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
  }
  problem.lagrangian_hessian = nullptr;
  Evaluator evaluator(problem, {10});
  EXPECT_FALSE(evaluator.lagrangian_hessian(problem.start, 1, Vector()));
  EXPECT_THROW(std::rethrow_exception(evaluator.failure()), std::logic_error);
}

}  // namespace
}  // namespace ricochet
