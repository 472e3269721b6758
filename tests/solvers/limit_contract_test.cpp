// What a solver returns when its budget ends within a search: what its library returns if it is
// called directly with a limit of its own, or the best evaluated point.

#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

std::vector<Problem> problems() {
  return {sphere(1, 3),
          limited(7),
          disc(),
          arc(),
          instance(suite_problem("classic-rosenbrock-5"), 3),
          instance(suite_problem("hs-26"), 1),
          instance(suite_problem("hs-105"), 2),
          instance(suite_problem("least-squares-08-rosenbrock-2x2-far"), 1)};
}

std::vector<std::int64_t> budgets_of(const Solver& solver) {
  const bool slopes = solver.capabilities.derivatives != Capabilities::Order::value;
  std::vector<std::int64_t> budgets = {1, 2, 5};
  for (int k = 1; k <= 10; ++k) budgets.push_back((slopes ? 90 : 30) * k);
  // A budget may end between two smoothing parameters, before the next has shown a point.
  if (solver.name == "continuation-nlopt-slsqp") {
    for (int k = 1; k <= 200; ++k) budgets.push_back(k);
  }
  return budgets;
}

/// Returns true if the run returned what the library returns, in the solver's coordinates, with the
/// largest limit that the budget allows, or its best evaluated point if it allows none.
bool as_its_library(const Solver& solver, const Problem& problem, const RunRecord& record) {
  const bool of_evaluations = solver.name.starts_with("nlopt-");  // others limit iterations
  const std::int64_t least_price = of_evaluations ? 1 : 1 + problem.dimension() / 2;
  const auto call = direct_call(solver.name);
  const Coordinates coordinates = coordinates_of(solver.name);
  Vector expected = record.trace.back().x;
  int good = 0, bad = static_cast<int>(record.budget.evaluations / least_price) + 2;
  while (bad - good > 1) {
    const int limit = std::midpoint(good, bad);
    Evaluator evaluator(problem, {1'000'000'000});
    const Vector x = call({problem, evaluator, coordinates, Random(record.seed)(), limit});
    const bool is_allowed = evaluator.ledger().charged <= record.budget.evaluations;
    (is_allowed ? good : bad) = limit;
    if (is_allowed) expected = x;
  }
  return (record.returned->x - expected).norm() <= 1e-12 * (1 + expected.norm());
}

class AtLimitContract : public OfSolver {};

// Of all runs that their budget ended within the first search, and that have evaluated a point.
TEST_P(AtLimitContract, WhatTheLibraryReturnsOrElseTheBestEvaluatedPointIsReturned) {
  if (solver().chooses) return;  // it has no library: Auto.RunsWhatItChose
  const bool own = solver().at_limit == AtLimit::own_point;
  std::vector<Problem> all = problems();
  if (!own) all.push_back(half_a_number());
  int cuts = 0, moved = 0;
  for (const Problem& problem : all) {
    if (!solver().accepts(problem)) continue;
    for (const std::int64_t budget : budgets_of(solver())) {
      // A call of Ipopt takes milliseconds.
      const bool is_long = budget > 200 || problem.dimension() > 5;
      if (is_long && solver().name.starts_with("ipopt")) continue;
      const RunRecord record = run(problem, solver(), {budget}, 0);
      if (record.termination_reason != TerminationReason::evaluations) continue;
      if (record.terminations.size() != 1 || record.trace.empty()) continue;
      SCOPED_TRACE(fmt::format("{}, budget {}", problem.name, budget));
      ++cuts;
      ASSERT_TRUE(record.returned);
      EXPECT_TRUE(own ? as_its_library(solver(), problem, record)
                      : !better(best_of(record), record.returned->true_values));
      moved += (record.returned->x - problem.start).norm() > 1e-6;
    }
  }
  EXPECT_GT(cuts, own ? 3 : 0);
  EXPECT_TRUE(moved > 0 || !own);
}

// However a search is ended, it has asked the same until then, so it returns the same.
TEST_P(AtLimitContract, APauseReturnsWhatABudgetReturns) {
  if (solver().name.starts_with("continuation-")) GTEST_SKIP() << "it pauses its solver itself";
  for (const Problem& problem : problems()) {
    if (!solver().accepts(problem) || problem.dimension() > 3) continue;
    for (const std::int64_t budget : {1, 4, 40}) {
      Evaluator evaluator(problem, {1'000'000});
      evaluator.allow(budget);
      Random random;
      EXPECT_EQ(solver().solve(evaluator, problem.start, random).point,
                solved(problem, solver(), budget).point)
          << problem.name << ", " << budget;
    }
  }
}

// The time ends at whatever call it does. The fireworks family divides what is left of the budget,
// so a run with another budget asks other points.
TEST_P(AtLimitContract, ATimeLimitReturnsWhatTheSameNumberOfEvaluationsReturns) {
  for (const Problem& problem : {disc(), sphere(2, 3)}) {
    if (!solver().accepts(problem)) continue;
    const RunRecord timed = run(problem, solver(), {1'000'000, 0.003}, 0);
    if (timed.termination_reason != TerminationReason::seconds || timed.trace.empty()) continue;
    ASSERT_TRUE(timed.returned) << problem.name;
    if (solver().at_limit == AtLimit::best_evaluated) {
      // A start that ended before the time did returned a point of its own.
      const bool only_start = timed.terminations.size() == 1;
      EXPECT_FALSE(only_start && better(best_of(timed), timed.returned->true_values));
      continue;
    }
    // The call that time refused may cost less than the one that the budget refuses.
    const RunRecord counted = run(problem, solver(), {timed.ledger.charged}, 0);
    if (counted.ledger.charged != timed.ledger.charged) continue;
    ASSERT_TRUE(counted.returned) << problem.name;
    EXPECT_EQ(counted.returned->x, timed.returned->x) << problem.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, AtLimitContract, testing::ValuesIn(all_solvers()), by_solver);

}  // namespace
}  // namespace ricochet
