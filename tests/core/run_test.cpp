#include "src/core/run.h"

#include <gtest/gtest.h>

#include <stdexcept>

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
    return SolverExit("done");
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
    return SolverExit("done");
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
