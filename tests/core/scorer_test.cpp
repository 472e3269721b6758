#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

TEST(Scorer, ScoresResidualsByTheTrueValuesAndNotByTheirSquares) {
  Problem problem = parabola(1);
  problem.residuals = [](const Vector& x) {
    return Residuals{x.array() - 0.75, Matrix::Identity(1, 1)};
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  for (const double x : {0.75, 0.5}) ASSERT_TRUE(evaluator.residuals(Vector::Constant(1, x)));
  ASSERT_EQ(scorer.trace().size(), 2U);
  EXPECT_EQ(scorer.trace()[0].true_values.objective, 0.25);
  EXPECT_EQ(scorer.trace()[1].true_values.objective, 0.0625);
  EXPECT_EQ(evaluator.ledger().values, 0) << "the solver has asked for none";

  problem.true_values = [](const Vector& x) { return TrueValues{-x[0], 0.0}; };
  Scorer judge(problem);
  Evaluator judged(problem, {100}, &judge);
  ASSERT_TRUE(judged.residuals(Vector::Constant(1, 0.5)));
  EXPECT_EQ(judge.best()->true_values.objective, -0.5);
  EXPECT_EQ(judge.best()->evaluations, 2);
}

TEST(Scorer, TracesOnlyImprovementsAndScoresThemByTheirTrueValues) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector& x) { return TrueValues{std::floor(10 * x[0]), 0.0}; };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  for (const double x : {0.9, 0.5, 0.55, 0.7, 0.05}) evaluator.objective(Vector::Constant(1, x));
  ASSERT_EQ(scorer.trace().size(), 3U);
  EXPECT_EQ(scorer.trace()[1].evaluations, 2);
  EXPECT_EQ(scorer.trace()[1].true_values.objective, 5.0);
  EXPECT_EQ(scorer.trace()[2].evaluations, 5);
  EXPECT_EQ(scorer.best()->true_values.objective, 0.0);
}

TEST(Scorer, NeverTracesATrueValuesThatIsNotANumber) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector& x) {
    return TrueValues{x[0] < 0.5 ? std::numeric_limits<double>::quiet_NaN() : 3.0, 0.0};
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  evaluator.objective(Vector::Constant(1, 0.1));
  EXPECT_TRUE(scorer.trace().empty());
  evaluator.objective(Vector::Constant(1, 0.9));
  ASSERT_EQ(scorer.trace().size(), 1U);
  EXPECT_EQ(scorer.trace()[0].true_values.objective, 3.0);
}

TEST(Scorer, TakesNoPointForReachedOfWhichASolverWasToldNoNumber) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector&) { return TrueValues{3.0, 0.0}; };
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] < 0.5 ? std::numeric_limits<double>::quiet_NaN() : 7.0, {}};
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  evaluator.objective(Vector::Constant(1, 0.1));
  EXPECT_TRUE(scorer.trace().empty());
  EXPECT_EQ(evaluator.ledger().charged, 1) << "it is paid all the same";
  evaluator.objective(Vector::Constant(1, 0.9));
  ASSERT_EQ(scorer.trace().size(), 1U);
  EXPECT_EQ(scorer.trace()[0].evaluations, 2);
}

TEST(Scorer, PrefersAFeasiblePointToALowerObjective) {
  Problem problem = parabola(1);
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) { return Values{x[0], Vector::Constant(1, 0.5 - x[0])}; };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  evaluator.values(Vector::Constant(1, 0.1));
  evaluator.values(Vector::Constant(1, 0.9));
  evaluator.values(Vector::Constant(1, 0.2));
  EXPECT_EQ(scorer.best()->true_values.objective, 0.9);
  EXPECT_EQ(scorer.best()->true_values.violation, 0.0);
}

TEST(Scorer, TellsOfEveryImprovementAtOnce) {
  const Problem problem = parabola(1);
  std::vector<double> told;
  Scorer scorer(problem, [&](const Improvement& step) { told.push_back(step.x[0]); });
  Evaluator evaluator(problem, {10}, &scorer);
  for (const double x : {0.9, 0.5, 0.75, 0.25}) {
    evaluator.objective(Vector::Constant(1, x));
    EXPECT_EQ(told.back(), scorer.best()->x[0]);
  }
  EXPECT_EQ(told, (std::vector<double>{0.9, 0.5, 0.25}));
}

}  // namespace
}  // namespace ricochet
