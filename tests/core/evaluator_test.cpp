#include "ricochet/evaluator.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "src/core/evaluator.h"
#include "src/core/instance.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(Evaluator, ChargesOneForValuesAndOnePlusNForDerivatives) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {100});
  ASSERT_TRUE(evaluator.values(Vector::Constant(3, 0.5)));
  EXPECT_EQ(evaluator.ledger().charged, 1);
  ASSERT_TRUE(evaluator.derivatives(Vector::Constant(3, 0.25)));
  EXPECT_EQ(evaluator.ledger().charged, 1 + 4);
  EXPECT_EQ(evaluator.ledger().values, 1);
  EXPECT_EQ(evaluator.ledger().derivatives, 1);
}

TEST(Evaluator, RemembersTheLastPoint) {
  const Problem problem = parabola(2);
  Evaluator evaluator(problem, {100});
  const Vector x = Vector::Constant(2, 0.5);
  const auto derivatives = evaluator.derivatives(x);
  const auto values = evaluator.values(x);
  EXPECT_EQ(evaluator.ledger().charged, 3);
  EXPECT_EQ(values->objective, derivatives->values.objective);
  ASSERT_TRUE(evaluator.values(Vector::Constant(2, 0.75)));
  ASSERT_TRUE(evaluator.derivatives(Vector::Constant(2, 0.75)));
  EXPECT_EQ(evaluator.ledger().charged, 3 + 1 + 2) << "values at this point were already paid";
}

TEST(Evaluator, ChargesWhoAsksForTheSameAgain) {
  const Problem problem = parabola(2);
  Evaluator evaluator(problem, {100});
  const Vector x = Vector::Constant(2, 0.5);
  for (const Part part : {Part::nothing, Part::objective, Part::inequalities, Part::equalities}) {
    ASSERT_TRUE(evaluator.values(x, part));
  }
  EXPECT_EQ(evaluator.ledger().charged, 1) << "each is another quantity";
  ASSERT_TRUE(evaluator.objective(x));
  EXPECT_EQ(evaluator.ledger().charged, 2);
  EXPECT_EQ(evaluator.ledger().values, 2) << "it was asked of the problem anew";
  ASSERT_TRUE(evaluator.values(x));
  EXPECT_EQ(evaluator.ledger().charged, 3);
  ASSERT_TRUE(evaluator.derivatives(x, Part::objective));
  ASSERT_TRUE(evaluator.derivatives(x, Part::inequalities));
  EXPECT_EQ(evaluator.ledger().charged, 3 + 2);
  ASSERT_TRUE(evaluator.derivatives(x, Part::objective));
  EXPECT_EQ(evaluator.ledger().charged, 3 + 2 + 3);
}

TEST(Evaluator, ChargesAGradientThePriceOfTheBudget) {
  Problem problem = parabola(4);
  problem.lagrangian_hessian = [](const Vector&, double factor, const Vector&) {
    return Matrix(2 * factor * Matrix::Identity(4, 4));
  };
  struct Price {
    std::optional<std::int64_t> of_gradient;
    std::int64_t charged, of_hessian;
  };
  for (const auto& [price, charged, of_hessian] :
       {Price{{}, 4, 10}, Price{0, 0, 1}, Price{1, 1, 2}, Price{3, 3, 7}, Price{10, 10, 25}}) {
    Budget budget{1000};
    budget.gradient_price = price;
    Evaluator evaluator(problem, budget);
    ASSERT_TRUE(evaluator.derivatives(Vector::Constant(4, 0.5)));
    EXPECT_EQ(evaluator.ledger().charged, 1 + charged);
    ASSERT_TRUE(evaluator.values(Vector::Constant(4, 0.25)));
    ASSERT_TRUE(evaluator.derivatives(Vector::Constant(4, 0.25)));
    EXPECT_EQ(evaluator.ledger().charged, 2 + 2 * charged) << "the value was paid";
    ASSERT_TRUE(evaluator.residuals(Vector::Constant(4, 0.75)));
    EXPECT_EQ(evaluator.ledger().charged, 3 + 3 * charged);
    ASSERT_TRUE(evaluator.lagrangian_hessian(Vector::Constant(4, 0.75), 1, Vector()));
    EXPECT_EQ(evaluator.ledger().charged, 3 + 3 * charged + of_hessian);
  }
}

TEST(Evaluator, EndsWhoAsksForGradientsThatCostNothing) {
  const Problem problem = parabola(2);
  Budget budget{10};
  budget.gradient_price = 0;
  for (const bool move : {false, true}) {
    Evaluator evaluator(problem, budget);
    Vector x = Vector::Constant(2, 0.5);
    int asked = 0;
    while (asked < 1000 && evaluator.derivatives(x)) {
      if (move) x[0] += 0.001;
      ++asked;
    }
    EXPECT_EQ(asked, 10);
  }
}

TEST(Evaluator, EndsASolverThatAsksForOnePointForEver) {
  const Problem problem = parabola(2);
  Evaluator evaluator(problem, {100});
  int asked = 0;
  while (evaluator.objective(problem.start)) ++asked;
  EXPECT_EQ(asked, 100);
}

TEST(Evaluator, RefusesOnceTheBudgetIsSpent) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {2});
  EXPECT_TRUE(evaluator.objective(Vector::Constant(1, 0.1)));
  EXPECT_TRUE(evaluator.objective(Vector::Constant(1, 0.2)));
  EXPECT_EQ(evaluator.remaining(), 0);
  EXPECT_FALSE(evaluator.objective(Vector::Constant(1, 0.3)));
  EXPECT_TRUE(evaluator.over());
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  EXPECT_EQ(evaluator.ledger().charged, 2);
  EXPECT_FALSE(evaluator.objective(Vector::Constant(1, 0.2))) << "not even what it remembers";
}

TEST(Evaluator, RefusesADerivativeThatTheBudgetDoesNotCover) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {3});
  EXPECT_FALSE(evaluator.derivatives(Vector::Constant(3, 0.5)));
  EXPECT_EQ(evaluator.ledger().charged, 0);
}

TEST(Evaluator, RefusesOnceTheTimeIsSpent) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {1000000, 0.0});
  EXPECT_FALSE(evaluator.objective(Vector::Constant(1, 0.1)));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::seconds);
}

TEST(Evaluator, RefusesPointsThatAreNotFiniteOrOfTheWrongLength) {
  const Problem problem = parabola(2);
  for (const Vector& x : {Vector(Vector::Constant(2, std::numeric_limits<double>::quiet_NaN())),
                          Vector(Vector::Constant(3, 0.5))}) {
    Evaluator evaluator(problem, {10});
    EXPECT_FALSE(evaluator.values(x));
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::bad_point);
    Evaluator other(problem, {10});
    EXPECT_FALSE(other.residuals(x));
    EXPECT_EQ(other.termination_reason(), TerminationReason::bad_point);
  }
}

TEST(Evaluator, EvaluatesAPointOutsideTheBoxAtItsProjection) {
  const Problem problem = parabola(1);
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  EXPECT_EQ(*evaluator.objective(Vector::Constant(1, 7.0)), *evaluator.objective(problem.upper));
  EXPECT_EQ(scorer.best()->x, problem.upper);
}

TEST(Evaluator, StoresAnExceptionOfTheProblemAndRefusesFromThenOn) {
  Problem problem = parabola(1);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  Evaluator evaluator(problem, {10});
  EXPECT_FALSE(evaluator.objective(Vector::Constant(1, 0.1)));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
  EXPECT_THROW(std::rethrow_exception(evaluator.failure()), std::runtime_error);
}

/// parabola(1), whose smoothed formulation has its best point at 0.25 + smoothing parameter.
Problem smoothed_parabola() {
  Problem problem = parabola(1);
  problem.smoothed = [problem](double smoothing) {
    Problem smooth = problem;
    smooth.evaluate = [problem, smoothing](const Vector& x) {
      return problem.evaluate((x.array() - smoothing).matrix());
    };
    return smooth;
  };
  return problem;
}

TEST(Evaluator, ShowsASmootherProblemButJudgesByTheTrueValues) {
  const Problem problem = smoothed_parabola();
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  evaluator.smooth(0.5);
  EXPECT_EQ(evaluator.objective(Vector::Constant(1, 0.75)), 0.0);
  EXPECT_EQ(scorer.best()->true_values.objective, 0.25);
  evaluator.smooth(0.25);
  EXPECT_EQ(evaluator.objective(Vector::Constant(1, 0.75)), 0.0625) << "not remembered";
  EXPECT_EQ(evaluator.ledger().charged, 2);
}

TEST(Evaluator, TellsTheBestPointShownAtTheSmoothingOfNow) {
  const Problem problem = smoothed_parabola();
  Evaluator evaluator(problem, {100});
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  evaluator.smooth(0.5);
  for (const double x : {0.25, 0.75, 1.0}) evaluator.values(Vector::Constant(1, x));
  EXPECT_EQ((*evaluator.best_shown())[0], 0.75);
  evaluator.smooth(0.25);
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  for (const double x : {0.75, 0.5}) evaluator.values(Vector::Constant(1, x));
  EXPECT_EQ((*evaluator.best_shown())[0], 0.5);
}

TEST(Evaluator, TellsASolverHowFarToTrustAGradient) {
  Problem problem = parabola(2);
  problem.smoothed = [problem](double) { return problem; };
  problem.differentiate = [differentiate = problem.differentiate](const Vector& x) {
    Derivatives d = differentiate(x);
    d.trust = {0.125, GradientDoubt::kink};
    return d;
  };
  for (const Problem& shown : {problem, instance(problem, 1), penalised(problem, 10)}) {
    Evaluator evaluator(shown, {100});
    const auto derivatives = evaluator.derivatives(shown.start);
    EXPECT_EQ(derivatives->trust.reach, 0.125);
    EXPECT_EQ(derivatives->trust.doubt, GradientDoubt::kink);
  }
}

TEST(Evaluator, RefusesWhatIsNotAllowedForNow) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {10});
  double x = 0;
  const auto spend = [&] {
    int asked = 0;
    while (evaluator.values(Vector::Constant(1, x += 0.01))) ++asked;
    return asked;
  };
  evaluator.allow(3);
  EXPECT_EQ(evaluator.remaining(), 3);
  EXPECT_EQ(spend(), 3);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::paused);
  EXPECT_TRUE(evaluator.over());
  evaluator.allow(4);
  EXPECT_FALSE(evaluator.over());
  EXPECT_EQ(spend(), 4);
  evaluator.allow(100);
  EXPECT_EQ(spend(), 3);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  evaluator.allow(100);
  EXPECT_TRUE(evaluator.over()) << "the budget is spent all the same";
}

TEST(Evaluator, RefusesASmoothingWhereThereIsNone) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {100});
  EXPECT_THROW(evaluator.smooth(0.5), std::logic_error);
}

}  // namespace
}  // namespace ricochet
