// What a solver returns when its budget ends within a search: what its library returns if it is
// called directly with a limit of its own, or the best evaluated point.

#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/solvers/solve.h"
#include "tests/support/test.h"

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

constexpr int full_budget = 300;  // three times as many with derivatives

std::vector<std::int64_t> tenths(const Solver& solver) {
  const bool slopes = solver.capabilities.derivatives != Capabilities::Order::value;
  std::vector<std::int64_t> budgets = {1, 2, 5};
  for (int k = 1; k <= 10; ++k) budgets.push_back((slopes ? 3 : 1) * full_budget * k / 10);
  return budgets;
}

/// A direct call of a library with a limit: the point that it returned, and what it was charged.
struct Direct {
  Vector x;
  std::int64_t charged = 0;
};

/// The direct call with the largest limit that stays within a budget; nothing if none does. An
/// iteration or evaluation is charged at least `price`.
std::optional<Direct> within(std::int64_t budget, std::int64_t price,
                             const std::function<Direct(int)>& call) {
  std::optional<Direct> found;
  int good = 0, bad = static_cast<int>(budget / price) + 2;
  while (bad - good > 1) {
    const int limit = std::midpoint(good, bad);
    Direct direct = call(limit);
    (direct.charged <= budget ? good : bad) = limit;
    if (direct.charged <= budget) found = std::move(direct);
  }
  return found;
}

/// What the solver's library does with a limit, in the solver's coordinates; `run_seed` is of the
/// run.
std::function<Direct(int)> library_of(const Solver& solver, const Problem& problem,
                                      std::uint64_t run_seed) {
  Random random(run_seed);
  return [&problem, seed = random(), coordinates = coordinates_of(solver.name),
          call = direct_call(solver.name)](int limit) {
    Evaluator evaluator(problem, {1'000'000'000});
    const Vector x = call({problem, evaluator, coordinates, seed, limit});
    return Direct{x, evaluator.ledger().charged};
  };
}

/// Returns true if the run returned what the library returns with the largest limit that the budget
/// allows, or its best evaluated point if it allows none.
bool as_its_library(const Solver& solver, const Problem& problem, const RunRecord& record) {
  const bool of_evaluations = solver.name.starts_with("nlopt-");  // others limit iterations
  const std::int64_t price = of_evaluations ? 1 : 1 + problem.dimension() / 2;
  const auto direct =
      within(record.budget.evaluations, price, library_of(solver, problem, record.seed));
  const Vector& expected = direct ? direct->x : record.trace.back().x;
  return record.returned && (record.returned->x - expected).norm() <= 1e-12 * (1 + expected.norm());
}

/// Calls `look` with every run of the solver that its budget ended within its first search, and
/// that has evaluated a point; returns how many these are.
int look_at_cuts(const Solver& solver, const std::vector<Problem>& on,
                 const std::function<void(const Problem&, const RunRecord&)>& look) {
  int cuts = 0;
  for (const Problem& problem : on) {
    if (!solver.accepts(problem)) continue;
    for (const std::int64_t budget : tenths(solver)) {
      // A call of Ipopt takes milliseconds.
      const bool own = solver.at_limit == AtLimit::own_point;
      if (own && solver.name.starts_with("ipopt") && (budget > 200 || problem.dimension() > 5)) {
        continue;
      }
      const RunRecord record = run(problem, solver, {budget}, 0);
      if (record.termination_reason != TerminationReason::evaluations) continue;
      if (record.terminations.size() != 1 || record.trace.empty()) continue;
      SCOPED_TRACE(fmt::format("{}, budget {}", problem.name, budget));
      look(problem, record);
      ++cuts;
    }
  }
  return cuts;
}

bool is_worse_than_the_best_evaluated(const RunRecord& record) {
  return !record.returned || better(best_of(record), record.returned->true_values);
}

class AtLimitContract : public testing::TestWithParam<Solver> {
 protected:
  const Solver& solver() const { return GetParam(); }
};
class OwnAtLimitContract : public AtLimitContract {};
class BestAtLimitContract : public AtLimitContract {};

TEST_P(OwnAtLimitContract, WhatTheLibraryReturnsAtItsLimitIsReturned) {
  int moved = 0;
  const auto look = [&](const Problem& problem, const RunRecord& record) {
    EXPECT_TRUE(as_its_library(solver(), problem, record));
    moved += (record.returned->x - problem.start).norm() > 1e-6;
  };
  EXPECT_GT(look_at_cuts(solver(), problems(), look), 3);
  EXPECT_GT(moved, 0);
}

TEST_P(BestAtLimitContract, TheBestEvaluatedPointIsReturned) {
  std::vector<Problem> all = problems();
  all.push_back(half_a_number());
  EXPECT_GT(look_at_cuts(solver(), all,
                         [](const Problem&, const RunRecord& record) {
                           EXPECT_FALSE(is_worse_than_the_best_evaluated(record));
                         }),
            0);
}

TEST_P(AtLimitContract, APointIsReturnedOnlyWhereOneWasEvaluated) {
  int returned = 0;
  for (const Problem& problem : problems()) {
    if (!solver().accepts(problem)) continue;
    for (const std::int64_t budget : {0, 1, 2, 3, 30}) {
      const RunRecord record = run(problem, solver(), {budget}, 0);
      EXPECT_LE(record.returned.has_value(), record.ledger.charged > 0) << problem.name;
      returned += record.returned.has_value();
    }
  }
  EXPECT_GT(returned, 0);
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
      EXPECT_FALSE(only_start && is_worse_than_the_best_evaluated(timed));
      continue;
    }
    // The call that time refused may cost less than the one that the budget refuses.
    const RunRecord counted = run(problem, solver(), {timed.ledger.charged}, 0);
    if (counted.ledger.charged != timed.ledger.charged) continue;
    ASSERT_TRUE(counted.returned) << problem.name;
    EXPECT_EQ(counted.returned->x, timed.returned->x) << problem.name;
  }
}

std::vector<Solver> returning(AtLimit what) {
  return solvers_that([&](const Solver& solver) { return solver.at_limit == what; });
}

INSTANTIATE_TEST_SUITE_P(Of, AtLimitContract, testing::ValuesIn(all_solvers()), by_solver);
INSTANTIATE_TEST_SUITE_P(Of, OwnAtLimitContract, testing::ValuesIn(returning(AtLimit::own_point)),
                         by_solver);
INSTANTIATE_TEST_SUITE_P(Of, BestAtLimitContract,
                         testing::ValuesIn(returning(AtLimit::best_evaluated)), by_solver);

}  // namespace
}  // namespace ricochet
