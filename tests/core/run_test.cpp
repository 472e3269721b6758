#include "ricochet/run.h"

#include "src/core/evaluator.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::Pair;

/// The true objectives of the trace after each of its evaluations.
std::vector<std::pair<std::int64_t, double>> objectives(const Scorer& scorer) {
  std::vector<std::pair<std::int64_t, double>> all;
  for (const Improvement& step : scorer.trace()) {
    all.emplace_back(step.evaluations, step.true_values.objective);
  }
  return all;
}

TEST(Scorer, ScoresResidualsByTheTrueValuesAndNotByTheirSquares) {
  Problem problem = parabola(1);
  problem.residuals = [](const Vector& x) {
    return Residuals{x.array() - 0.75, Matrix::Identity(1, 1)};
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  for (const double x : {0.75, 0.5}) ASSERT_TRUE(evaluator.residuals(Vector::Constant(1, x)));
  EXPECT_THAT(objectives(scorer), ElementsAre(Pair(2, 0.25), Pair(4, 0.0625)));
  EXPECT_EQ(evaluator.ledger().values, 0) << "the solver has asked for none";

  problem.true_values = [](const Vector& x) { return TrueValues{-x[0], 0.0}; };
  Scorer judge(problem);
  ASSERT_TRUE(Evaluator(problem, {100}, &judge).residuals(Vector::Constant(1, 0.5)));
  EXPECT_THAT(objectives(judge), ElementsAre(Pair(2, -0.5)));
}

TEST(Scorer, TracesOnlyImprovementsAndScoresThemByTheirTrueValues) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector& x) { return TrueValues{std::floor(10 * x[0]), 0.0}; };
  std::vector<double> told;
  Scorer scorer(problem, [&](const Improvement& step) { told.push_back(step.x[0]); });
  Evaluator evaluator(problem, {10}, &scorer);
  for (const double x : {0.9, 0.5, 0.55, 0.7, 0.05}) {
    evaluator.objective(Vector::Constant(1, x));
    EXPECT_EQ(told.back(), scorer.best()->x[0]) << "told at once";
  }
  EXPECT_THAT(objectives(scorer), ElementsAre(Pair(1, 9), Pair(2, 5), Pair(5, 0)));
  EXPECT_THAT(told, ElementsAre(0.9, 0.5, 0.05));
}

TEST(Scorer, NeverTracesAPointWhoseTrueValuesOrWhatTheSolverWasToldAreNoNumber) {
  Problem problem = parabola(1);
  problem.true_values = [](const Vector& x) {
    return TrueValues{x[0] < 0.25 ? quiet_nan : 3.0, x[0] < 0.5 ? quiet_nan : 0.0};
  };
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] > 0.5 && x[0] < 0.75 ? quiet_nan : 7.0, {}};
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  for (const double x : {0.1, 0.3, 0.6, 0.9}) evaluator.objective(Vector::Constant(1, x));
  EXPECT_THAT(objectives(scorer), ElementsAre(Pair(4, 3.0)));
  EXPECT_EQ(evaluator.ledger().charged, 4) << "all are paid the same";
}

TEST(Scorer, PrefersAFeasiblePointToALowerObjective) {
  Problem problem = limited(-0.5);
  problem.lower[0] = -18;
  Scorer scorer(problem);
  Evaluator evaluator(problem, {10}, &scorer);
  for (const double x : {-0.1, -0.9, -0.2}) evaluator.values(Vector::Constant(1, x));
  EXPECT_THAT(scorer.best()->true_values, FieldsAre(0.9, 0.0));
}

Solver solver_that(const decltype(Solver::solve)& solves) {
  Solver solver;
  solver.name = "that";
  solver.solve = solves;
  return solver;
}

/// Asks `points` times for uniform points, then returns.
Solver sampler(int points) {
  return solver_that([points](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    for (int i = 0; i < points && evaluator.objective(x); ++i) {
      x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    }
    return SolverTermination{"done"};
  });
}

TEST(Run, RestartsUntilTheBudgetIsSpentOrTenRestartsAskForNothing) {
  const RunRecord record = run(parabola(2), sampler(10), {55}, 0);
  EXPECT_EQ(record.ledger.charged, 55);
  EXPECT_EQ(record.terminations.size(), 6U);
  EXPECT_EQ(record.termination_reason, TerminationReason::evaluations);
  const RunRecord idle = run(parabola(2), sampler(0), {55}, 0);
  EXPECT_EQ(idle.ledger.charged, 0);
  EXPECT_EQ(idle.terminations.size(), 10U);
  int calls = 0;
  const Solver lazy = solver_that([&calls](Evaluator& evaluator, const Vector& start, Random&) {
    if (++calls % 3 != 0) evaluator.objective(start);
    return SolverTermination{"done"};
  });
  EXPECT_EQ(run(parabola(2), lazy, {55}, 0).ledger.charged, 55);
}

TEST(Run, GivesTheSameTraceForTheSameSeedAndEverySolverTheSameStarts) {
  const auto points = [](const Solver& solver, int number) {
    std::vector<Vector> all;
    for (const Improvement& step : run(parabola(2), solver, {50}, number).trace)
      all.push_back(step.x);
    return all;
  };
  const std::vector<Vector> one = points(sampler(10), 1);
  EXPECT_EQ(points(sampler(10), 1), one);
  EXPECT_NE(points(sampler(10), 2).back(), one.back());
  Solver other = sampler(1);
  other.name = "another";
  EXPECT_EQ(points(other, 1).front(), one.front());
}

TEST(Run, KeepsThePointThatIsReturnedPointBesideTheBestThatWasFound) {
  const Problem problem = parabola(1);
  // Looks at 0.25, the best point, but ends at 0.75.
  const Solver modest = solver_that([](Evaluator& evaluator, const Vector&, Random&) {
    evaluator.objective(Vector::Constant(1, 0.25));
    return SolverTermination{"done", Vector::Constant(1, 0.75)};
  });
  const RunRecord record = run(problem, modest, {3}, 0);
  EXPECT_EQ(record.returned.value().x[0], 0.75);
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

TEST(Run, RecordsWhatTheProblemOrTheSolverThrewAndKeepsTheTrace) {
  Problem problem = parabola(1);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  const RunRecord broken = run(problem, sampler(5), {50}, 0);
  EXPECT_EQ(broken.failure, "broken scene");
  EXPECT_EQ(broken.termination_reason, TerminationReason::failure);
  const Solver torn = solver_that([](Evaluator& evaluator, const Vector& start, Random&) {
    evaluator.objective(start);
    throw std::logic_error("solver broke");
    return SolverTermination();
  });
  const RunRecord record = run(parabola(1), torn, {50}, 0);
  EXPECT_EQ(record.failure, "solver broke");
  EXPECT_EQ(record.trace.size(), 1U);
}

TEST(Verdict, IsSolvedWhereAFeasiblePointFirstReachesTheTarget) {
  const auto verdict_on = [](const std::vector<Improvement>& trace, const Problem& problem) {
    RunRecord record;
    record.trace = trace;
    return judge(record, problem, 1.0);
  };
  Problem problem = parabola(1);
  const Verdict solved =
      verdict_on({{1, 0.1, {5, 0}, {}}, {4, 0.2, {0.5, 0}, {}}, {9, 0.3, {0, 0}, {}}}, problem);
  EXPECT_TRUE(solved.solved);
  EXPECT_EQ(solved.evaluations_to_solve, 4);
  EXPECT_EQ(solved.seconds_to_solve, 0.2);
  EXPECT_EQ(solved.objective, 0.0);
  EXPECT_EQ(solved.optimality_gap, 0.0);
  const Verdict infeasible = verdict_on({{1, 0.1, {-3, 0.5}, {}}}, problem);
  EXPECT_FALSE(infeasible.feasible || infeasible.objective || infeasible.solved);
  problem.best_known.reset();
  const Verdict open = verdict_on({{1, 0.1, {3, 0}, {}}}, problem);
  EXPECT_EQ(open.objective, 3.0);
  EXPECT_FALSE(open.optimality_gap || open.solved);
}

}  // namespace
}  // namespace ricochet
