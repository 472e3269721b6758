// What a solver returns when its budget ends within a search: what its library returns if it is
// called directly with a limit of its own, or the best evaluated point.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/instance.h"
#include "tests/solvers/direct_calls.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

Problem classic_problem(const std::string& name, int number) {
  for (const Family& family : classic::families()) {
    for (const Problem& problem : family.problems) {
      if (problem.name == name) return ricochet::instance(problem, number);
    }
  }
  throw std::logic_error("no problem " + name);
}

std::vector<Problem> problems() {
  return {sphere(1, 3),
          limited(7),
          disc(),
          arc(),
          classic_problem("classic-rosenbrock-5", 3),
          classic_problem("hs-26", 1),
          classic_problem("hs-105", 2),
          classic_problem("least-squares-08-rosenbrock-2x2-far", 1)};
}

constexpr int evaluations = 300;  // three times as many with derivatives

std::vector<std::int64_t> tenths(const Solver& solver) {
  const bool slopes = solver.capabilities.derivatives != Capabilities::Order::value;
  std::vector<std::int64_t> budgets = {1, 2, 5};
  for (int k = 1; k <= 10; ++k) budgets.push_back((slopes ? 3 : 1) * evaluations * k / 10);
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

/// A run that its budget ended within its first search, and the values at the point returned.
std::optional<RunRecord> cut(const Problem& problem, const Solver& solver, std::int64_t budget) {
  RunRecord record = run(problem, solver, {budget}, 0);
  const bool within_first = record.termination_reason == TerminationReason::evaluations &&
                            record.terminations.size() == 1 && record.ledger.charged > 0;
  return within_first ? std::optional(std::move(record)) : std::nullopt;
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

class AtLimitContract : public testing::TestWithParam<Solver> {};
class OwnAtLimitContract : public AtLimitContract {};
class BestAtLimitContract : public AtLimitContract {};

TEST_P(OwnAtLimitContract, WhatTheLibraryReturnsAtItsLimitIsReturned) {
  const Solver& solver = GetParam();
  int compared = 0, moved = 0;
  for (const Problem& problem : problems()) {
    if (!solver.accepts(problem)) continue;
    for (const std::int64_t budget : tenths(solver)) {
      // A call of Ipopt takes milliseconds.
      if (solver.name.starts_with("ipopt") && (budget > 200 || problem.dimension() > 5)) continue;
      const auto record = cut(problem, solver, budget);
      if (!record || record->trace.empty()) continue;
      EXPECT_TRUE(as_its_library(solver, problem, *record)) << problem.name << ", " << budget;
      moved += (record->returned->x - problem.start).norm() > 1e-6;
      ++compared;
    }
  }
  EXPECT_GT(compared, 3);
  EXPECT_GT(moved, 0);
}

// Prints, for each solver, how often the returned point of a run that its budget ended is worse
// than its best evaluated one, and how often it is what its library returns at its own limit:
// twelve problems, ten budgets. Run with
// --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_Table'.
TEST(AtItsLimit, DISABLED_Table) {
  std::vector<Problem> twelve = {sphere(2, 3), disc(), arc()};
  for (const auto& [name, number] :
       {std::pair("classic-rosenbrock-5", 3), std::pair("classic-sphere-5", 2),
        std::pair("classic-rastrigin-5", 1), std::pair("classic-ackley-5", 4),
        std::pair("hs-16", 1), std::pair("hs-26", 1), std::pair("hs-71", 1), std::pair("hs-105", 2),
        std::pair("least-squares-08-rosenbrock-2x2-far", 1)}) {
    twelve.push_back(classic_problem(name, number));
  }
  fmt::print("solver | returns | runs cut | worse than best evaluated | as its library\n");
  for (const Solver& solver : all_solvers()) {
    int cuts = 0, worse = 0, same = 0;
    const bool own = solver.at_limit == AtLimit::own_point;
    for (const Problem& problem : twelve) {
      if (!solver.accepts(problem)) continue;
      for (int k = 1; k <= 10; ++k) {
        const auto record = cut(problem, solver, tenths(solver)[static_cast<std::size_t>(2 + k)]);
        if (!record || record->trace.empty()) continue;
        ++cuts;
        worse += !record->returned ||
                 better(record->trace.back().true_values, record->returned->true_values);
        same += own && as_its_library(solver, problem, *record);
      }
    }
    fmt::print("{} | {} | {} | {} | {}\n", solver.name, own ? "its own point" : "best evaluated",
               cuts, worse, own ? fmt::format("{}", same) : "-");
  }
}

TEST_P(BestAtLimitContract, TheBestEvaluatedPointIsReturned) {
  const Solver& solver = GetParam();
  int compared = 0;
  std::vector<Problem> all = problems();
  all.push_back(half_a_number());
  for (const Problem& problem : all) {
    if (!solver.accepts(problem)) continue;
    for (const std::int64_t budget : tenths(solver)) {
      const auto record = cut(problem, solver, budget);
      if (!record || record->trace.empty()) continue;
      ASSERT_TRUE(record->returned) << problem.name << " " << budget;
      const TrueValues& best = record->trace.back().true_values;
      EXPECT_FALSE(better(best, record->returned->true_values))
          << problem.name << ", budget " << budget << ": " << best.objective << " evaluated, "
          << record->returned->true_values.objective << " returned";
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

TEST_P(AtLimitContract, APointIsReturnedOnlyWhereOneWasEvaluated) {
  int returned = 0;
  for (const Problem& problem : problems()) {
    if (!GetParam().accepts(problem)) continue;
    for (const std::int64_t budget : {0, 1, 2, 3, 30}) {
      const RunRecord record = run(problem, GetParam(), {budget}, 0);
      EXPECT_LE(record.returned.has_value(), record.ledger.charged > 0) << problem.name;
      returned += record.returned.has_value();
    }
  }
  EXPECT_GT(returned, 0);
}

// However a search is ended, it has asked the same until then, so it returns the same.
TEST_P(AtLimitContract, APauseReturnsWhatABudgetReturns) {
  const Solver& solver = GetParam();
  if (solver.name.starts_with("continuation-")) GTEST_SKIP() << "it pauses its solver itself";
  for (const Problem& problem : problems()) {
    if (!solver.accepts(problem) || problem.dimension() > 3) continue;
    for (const std::int64_t budget : {1, 4, 40}) {
      std::vector<std::optional<Vector>> returned;
      for (const bool paused : {false, true}) {
        Evaluator evaluator(problem, {paused ? 1'000'000 : budget});
        if (paused) evaluator.allow(budget);
        Random random;
        returned.push_back(solver.solve(evaluator, problem.start, random).point);
      }
      EXPECT_EQ(returned[0], returned[1]) << problem.name << ", " << budget;
    }
  }
}

// The time ends at whatever call it does. The fireworks family divides what is left of the budget,
// so a run with another budget asks other points.
TEST_P(AtLimitContract, ATimeLimitReturnsWhatTheSameNumberOfEvaluationsReturns) {
  const Solver& solver = GetParam();
  for (const Problem& problem : {disc(), sphere(2, 3)}) {
    if (!solver.accepts(problem)) continue;
    const RunRecord timed = run(problem, solver, {1'000'000, 0.003}, 0);
    if (timed.termination_reason != TerminationReason::seconds || timed.trace.empty()) continue;
    ASSERT_TRUE(timed.returned) << problem.name;
    if (solver.at_limit == AtLimit::best_evaluated) {
      // A start that ended before the time did returned a point of its own.
      const bool only_start = timed.terminations.size() == 1;
      EXPECT_FALSE(only_start &&
                   better(timed.trace.back().true_values, timed.returned->true_values));
      continue;
    }
    // The call that time refused may cost less than the one that the budget refuses.
    const RunRecord counted = run(problem, solver, {timed.ledger.charged}, 0);
    if (counted.ledger.charged != timed.ledger.charged) continue;
    ASSERT_TRUE(counted.returned) << problem.name;
    EXPECT_EQ(counted.returned->x, timed.returned->x) << problem.name;
  }
}

std::vector<Solver> returning(AtLimit what) {
  std::vector<Solver> solvers = all_solvers();
  std::erase_if(solvers, [&](const Solver& solver) { return solver.at_limit != what; });
  return solvers;
}

std::string name_of(const testing::TestParamInfo<Solver>& tested) {
  return test_name(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(Of, AtLimitContract, testing::ValuesIn(all_solvers()), name_of);
INSTANTIATE_TEST_SUITE_P(Of, OwnAtLimitContract, testing::ValuesIn(returning(AtLimit::own_point)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Of, BestAtLimitContract,
                         testing::ValuesIn(returning(AtLimit::best_evaluated)), name_of);

}  // namespace
}  // namespace ricochet
