#include "src/core/run.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "src/core/verdict.h"
#include "tests/core/test_problems.h"

namespace ricochet {
namespace {

/// Asks `points` times for uniform points, then returns.
Solver sampler(int points) {
  Solver solver;
  solver.name = "sampler";
  solver.accepts = [](const Problem&) { return true; };
  solver.solve = [points](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    for (int i = 0; i < points && evaluator.objective(x); ++i) {
      for (double& c : x) c = std::uniform_real_distribution<double>(0, 1)(random);
    }
    return SolverExit{"done"};
  };
  return solver;
}

TEST(Run, RestartsUntilTheBudgetIsSpent) {
  const RunRecord record = run(parabola(2), sampler(10), {55}, 0);
  EXPECT_EQ(record.ledger.charged, 55);
  EXPECT_EQ(record.exits.size(), 6U);
  EXPECT_EQ(record.refusal, Refusal::evaluations);
}

TEST(Run, StopsWhenTenRestartsAskForNothing) {
  const RunRecord record = run(parabola(2), sampler(0), {55}, 0);
  EXPECT_EQ(record.exits.size(), 10U);
  EXPECT_EQ(record.ledger.charged, 0);
}

TEST(Run, GoesOnAfterARestartThatAskedForNothing) {
  Solver lazy = sampler(1);
  int calls = 0;
  lazy.solve = [&calls](Evaluator& evaluator, const Vector& start, Random&) {
    if (++calls % 3 != 0) evaluator.objective(start);
    return SolverExit{"done"};
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
    return SolverExit{"done", Vector::Constant(1, 0.75)};
  };
  return solver;
}

TEST(Run, KeepsThePointThatIsHandedOverBesideTheBestThatWasFound) {
  const Problem problem = parabola(1);
  const RunRecord record = run(problem, modest(), {3}, 0);
  ASSERT_TRUE(record.handed_over);
  EXPECT_EQ(record.handed_over->x[0], 0.75);
  EXPECT_EQ(record.handed_over->truth.objective, 0.25);
  const Verdict verdict = judge(record, problem, 0.01);
  EXPECT_TRUE(verdict.solved);
  EXPECT_FALSE(verdict.handed_over_solved);
  EXPECT_EQ(verdict.handed_over_regret, 0.25);
}

TEST(Run, TakesTheBestPointShownForTheOneHandedOverWhereThereIsNone) {
  Problem problem = parabola(1);
  problem.truth = [](const Vector& x) { return Truth{-x[0], 0.0}; };
  const RunRecord record = run(problem, sampler(10), {20}, 0);
  ASSERT_TRUE(record.handed_over);
  EXPECT_EQ(record.handed_over->truth.objective, -record.handed_over->x[0]);
  EXPECT_GT(record.handed_over->truth.objective, record.trace.back().truth.objective)
      << "it cannot know the truth";
}

TEST(Run, RecordsWhatTheProblemThrew) {
  Problem problem = parabola(1);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  const RunRecord record = run(problem, sampler(5), {50}, 0);
  EXPECT_EQ(record.failure, "broken scene");
  EXPECT_EQ(record.refusal, Refusal::failure);
}

TEST(Run, RecordsWhatTheSolverThrewAndKeepsTheTrace) {
  Solver solver = sampler(5);
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverExit {
    evaluator.objective(start);
    throw std::logic_error("solver broke");
  };
  const RunRecord record = run(parabola(1), solver, {50}, 0);
  EXPECT_EQ(record.failure, "solver broke");
  EXPECT_EQ(record.trace.size(), 1U);
}

}  // namespace
}  // namespace ricochet
