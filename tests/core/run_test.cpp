#include "ricochet/run.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// Asks `points` times for uniform points, then returns.
Solver sampler(int points) {
  Solver solver;
  solver.name = "sampler";
  solver.solve = [points](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    for (int i = 0; i < points && evaluator.objective(x); ++i) {
      for (double& c : x) c = std::uniform_real_distribution<double>(0, 1)(random);
    }
    return SolverTermination{"done"};
  };
  return solver;
}

TEST(Run, RestartsUntilTheBudgetIsSpent) {
  const RunRecord record = run(parabola(2), sampler(10), {55}, 0);
  EXPECT_EQ(record.ledger.charged, 55);
  EXPECT_EQ(record.terminations.size(), 6U);
  EXPECT_EQ(record.termination_reason, TerminationReason::evaluations);
}

TEST(Run, StopsWhenTenRestartsAskForNothing) {
  const RunRecord record = run(parabola(2), sampler(0), {55}, 0);
  EXPECT_EQ(record.terminations.size(), 10U);
  EXPECT_EQ(record.ledger.charged, 0);
}

TEST(Run, GoesOnAfterARestartThatAskedForNothing) {
  Solver lazy = sampler(1);
  int calls = 0;
  lazy.solve = [&calls](Evaluator& evaluator, const Vector& start, Random&) {
    if (++calls % 3 != 0) evaluator.objective(start);
    return SolverTermination{"done"};
  };
  const RunRecord record = run(parabola(2), lazy, {55}, 0);
  EXPECT_EQ(record.ledger.charged, 55);
}

TEST(Run, GivesTheSameTraceForTheSameSeedAndAnotherForAnotherRun) {
  const RunRecord a = run(parabola(2), sampler(10), {50}, 1);
  const RunRecord b = run(parabola(2), sampler(10), {50}, 1);
  const RunRecord c = run(parabola(2), sampler(10), {50}, 2);
  ASSERT_EQ(a.trace.size(), b.trace.size());
  for (std::size_t i = 0; i < a.trace.size(); ++i) EXPECT_EQ(a.trace[i].x, b.trace[i].x);
  EXPECT_NE(a.trace.back().x, c.trace.back().x);
}

TEST(Run, GivesEverySolverTheSameStarts) {
  Solver other = sampler(1);
  other.name = "another";
  const RunRecord a = run(parabola(2), sampler(1), {4}, 1);
  const RunRecord b = run(parabola(2), other, {4}, 1);
  EXPECT_EQ(a.trace.front().x, b.trace.front().x);
}

/// Looks at 0.25, the best point, but ends at 0.75.
Solver modest() {
  Solver solver = sampler(0);
  solver.solve = [](Evaluator& evaluator, const Vector&, Random&) {
    evaluator.objective(Vector::Constant(1, 0.25));
    return SolverTermination{"done", Vector::Constant(1, 0.75)};
  };
  return solver;
}

TEST(Run, KeepsThePointThatIsReturnedPointBesideTheBestThatWasFound) {
  const Problem problem = parabola(1);
  const RunRecord record = run(problem, modest(), {3}, 0);
  ASSERT_TRUE(record.returned);
  EXPECT_EQ(record.returned->x[0], 0.75);
  EXPECT_EQ(record.returned->true_values.objective, 0.25);
  const Verdict verdict = judge(record, problem, 0.01);
  EXPECT_TRUE(verdict.solved);
  EXPECT_FALSE(verdict.returned_solved);
  EXPECT_EQ(verdict.returned_optimality_gap, 0.25);
}

TEST(Run, TakesTheBestPointShownForTheOneReturnedPointWhereThereIsNone) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector& x) { return TrueValues{-x[0], 0.0}; };
  const RunRecord record = run(problem, sampler(10), {20}, 0);
  ASSERT_TRUE(record.returned);
  EXPECT_EQ(record.returned->true_values.objective, -record.returned->x[0]);
  EXPECT_GT(record.returned->true_values.objective, record.trace.back().true_values.objective)
      << "it cannot know the true objective";
}

TEST(Run, RecordsWhatTheProblemThrew) {
  Problem problem = parabola(1);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  const RunRecord record = run(problem, sampler(5), {50}, 0);
  EXPECT_EQ(record.failure, "broken scene");
  EXPECT_EQ(record.termination_reason, TerminationReason::failure);
}

TEST(Run, RecordsWhatTheSolverThrewAndKeepsTheTrace) {
  Solver solver = sampler(5);
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    evaluator.objective(start);
    throw std::logic_error("solver broke");
  };
  const RunRecord record = run(parabola(1), solver, {50}, 0);
  EXPECT_EQ(record.failure, "solver broke");
  EXPECT_EQ(record.trace.size(), 1U);
}

}  // namespace
}  // namespace ricochet
