// What every solver promises, whatever is behind it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <set>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "tests/support/scenes.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

std::vector<Problem> small_problems() {
  return {sphere(1, 3), sphere(2, 3), sphere(5, -20),    staircase(),       disc(),
          plateau(1),   plateau(2),   never_a_number(1), never_a_number(2), half_a_number(),
          limited(7)};
}

void expect_same_trace(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.ledger.charged, b.ledger.charged) << a.problem;
  EXPECT_EQ(a.terminations, b.terminations) << a.problem;
  ASSERT_EQ(a.trace.size(), b.trace.size()) << a.problem;
  for (std::size_t k = 0; k < a.trace.size(); ++k) {
    EXPECT_EQ(a.trace[k].evaluations, b.trace[k].evaluations) << a.problem;
    EXPECT_EQ(a.trace[k].x, b.trace[k].x) << a.problem;
    const TrueValues& p = a.trace[k].true_values;
    const TrueValues& q = b.trace[k].true_values;
    EXPECT_TRUE(p.objective == q.objective || (std::isnan(p.objective) && std::isnan(q.objective)))
        << a.problem;
    EXPECT_EQ(p.violation, q.violation) << a.problem;
  }
}

/// All points that a single call of `solve` asks for, from the problem's start.
std::vector<Vector> asked_points(const Solver& solver, const Problem& problem, std::uint64_t seed,
                                 std::int64_t budget = 100) {
  std::vector<Vector> asked;
  Problem recorded = problem;
  recorded.evaluate = [&](const Vector& x) {
    asked.push_back(x);
    return problem.evaluate(x);
  };
  recorded.differentiate = [&](const Vector& x) {
    asked.push_back(x);
    return problem.differentiate(x);
  };
  recorded.residuals = [&](const Vector& x) {
    asked.push_back(x);
    return problem.residuals(x);
  };
  recorded.true_values = [&](const Vector& x) { return true_values_of(problem.evaluate(x)); };
  recorded.smoothed = nullptr;
  if (problem.smoothed) recorded.smoothed = [recorded](double) { return recorded; };
  Evaluator evaluator(recorded, {budget});
  Random random(seed);
  solver.solve(evaluator, problem.start, random);
  return asked;
}

/// So often a solver may ask after it was refused: some finish a generation of about 100, and
/// Ceres's trust region tries some 170 shorter steps before it gives up.
constexpr std::int64_t most_refused = 500;

class SolverContract : public testing::TestWithParam<Solver> {
 protected:
  const Solver& solver() const { return GetParam(); }

  /// The small problems it accepts; at least one.
  std::vector<Problem> accepted() const {
    std::vector<Problem> problems = small_problems();
    problems.erase(std::remove_if(problems.begin(), problems.end(),
                                  [&](const Problem& p) { return !solver().accepts(p); }),
                   problems.end());
    EXPECT_FALSE(problems.empty());
    return problems;
  }

  /// The smallest sphere it accepts, or the simplest of constraints.
  Problem easy() const {
    for (const Problem& problem : {sphere(1, 3), sphere(2, 3), limited(7)}) {
      if (solver().accepts(problem)) return problem;
    }
    return disc();
  }
};

TEST_P(SolverContract, SpendsItsBudgetAndNoMore) {
  for (const Problem& problem : accepted()) {
    for (const std::int64_t budget : {3, 50, 200}) {
      const RunRecord record = run(problem, solver(), {budget}, 0);
      EXPECT_LE(record.ledger.charged, budget) << problem.name;
      EXPECT_EQ(record.failure, "") << problem.name;
      if (problem.name == "sphere") {
        const Eigen::Index n = problem.dimension();
        const Eigen::Index dearest = std::max(1 + n, n * (n + 1) / 2);  // call, in evaluations
        EXPECT_GT(record.ledger.charged, budget - dearest);
        EXPECT_EQ(record.termination_reason, TerminationReason::evaluations);
      }
    }
  }
}

TEST_P(SolverContract, EndsAtOnceWhereTheEvaluatorRefusesAtOnce) {
  for (const Problem& problem : accepted()) {
    for (const std::int64_t budget : {0, 1, 2}) {
      const RunRecord record = run(problem, solver(), {budget}, 0);
      EXPECT_LE(record.ledger.refused, most_refused) << problem.name;
      EXPECT_LE(record.ledger.charged, budget) << problem.name;
      EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator") << problem.name;
    }
  }
}

TEST_P(SolverContract, EndsWhenTheTimeIsSpent) {
  const RunRecord record = run(easy(), solver(), {1'000'000'000, 0.02}, 0);
  EXPECT_LE(record.ledger.refused, most_refused);
  EXPECT_EQ(record.termination_reason, TerminationReason::seconds);
  EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
}

TEST_P(SolverContract, GivesTheSameTraceForTheSameRun) {
  for (const Problem& problem : accepted()) {
    const RunRecord first = run(problem, solver(), {150}, 1);
    run(problem, solver(), {40}, 2);  // leaves nothing behind in the library
    expect_same_trace(first, run(problem, solver(), {150}, 1));
  }
}

/// Sum of 100 (x_{k+1} - x_k^2)^2 + (1 - x_k)^2 on [-5, 10]^7.
Problem bent_valley() {
  Problem problem = sphere(7, -3);
  problem.name = "bent valley";
  const auto values_at = [](const Vector& x) {
    Values values;
    for (Eigen::Index k = 0; k + 1 < x.size(); ++k) {
      const double bend = x[k + 1] - x[k] * x[k];
      values.objective += 100 * bend * bend + (1 - x[k]) * (1 - x[k]);
    }
    return values;
  };
  problem.evaluate = values_at;
  problem.differentiate = [values_at](const Vector& x) {
    Derivatives derivatives{values_at(x), Vector::Zero(x.size()), Matrix(0, x.size())};
    for (Eigen::Index k = 0; k + 1 < x.size(); ++k) {
      const double bend = x[k + 1] - x[k] * x[k];
      derivatives.gradient[k] -= 400 * bend * x[k] + 2 * (1 - x[k]);
      derivatives.gradient[k + 1] += 200 * bend;
    }
    return derivatives;
  };
  return problem;
}

// What sums several numbers at once may sum those before an aligned address one by one.
TEST_P(SolverContract, AsksTheSameWhereverItsMemoryLies) {
  const Problem problem = bent_valley();
  if (!solver().accepts(problem)) GTEST_SKIP() << "it takes no such problem";
  // Derivatives are paid, and models grow with what was asked.
  const std::int64_t budget =
      problem.differentiate && solver().name != "dlib-global-search" ? 800 : 100;
  const std::vector<Vector> first = asked_points(solver(), problem, 1, budget);
  Random random(1);
  for (int repeat = 0; repeat < 8; ++repeat) {
    std::vector<std::vector<char>> occupied(5000);
    for (std::vector<char>& block : occupied) block.resize(random() % 2000);
    for (std::vector<char>& block : occupied) {
      if (random() % 2 == 0) std::vector<char>().swap(block);
    }
    EXPECT_TRUE(asked_points(solver(), problem, 1, budget) == first) << "repeat " << repeat;
  }
}

TEST_P(SolverContract, DrawsFromItsRandomStateIfItSaysSoAndOnlyThen) {
  const Problem problem = easy();
  const std::vector<Vector> a = asked_points(solver(), problem, 1);
  bool differs = false;  // a toss of a coin may come out alike for two seeds
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    differs = differs || asked_points(solver(), problem, seed) != a;
  }
  EXPECT_EQ(differs, solver().stochastic);
  EXPECT_EQ(a, asked_points(solver(), problem, 1));
}

TEST_P(SolverContract, StaysInTheBox) {
  for (const Problem& problem : accepted()) {
    for (const Improvement& step : run(problem, solver(), {150}, 1).trace) {
      EXPECT_TRUE((step.x.array() >= problem.lower.array()).all()) << problem.name;
      EXPECT_TRUE((step.x.array() <= problem.upper.array()).all()) << problem.name;
    }
  }
}

TEST_P(SolverContract, EndsAndReportsWhenTheProblemThrows) {
  for (const int calls : {0, 1, 7}) {
    const Problem problem = breaks_after(calls, easy().dimension());
    const RunRecord record = run(problem, solver(), {10000}, 0);
    EXPECT_EQ(record.failure, "broken scene");
    EXPECT_EQ(record.termination_reason, TerminationReason::failure);
    const Ledger& ledger = record.ledger;
    EXPECT_EQ(ledger.values + ledger.derivatives + ledger.hessians, calls);
    EXPECT_EQ(record.terminations.back().reason, "stopped by the evaluator");
  }
}

class PlaneContract : public SolverContract {};

TEST_P(PlaneContract, GetsPastValuesThatAreNotNumbers) {
  Problem problem = half_a_number();
  int numbers = 0;
  const auto evaluate = problem.evaluate;
  problem.evaluate = [&](const Vector& x) {
    const Values values = evaluate(x);
    numbers += std::isfinite(values.objective);
    return values;
  };
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * (x.array() - 3); });
  run(problem, solver(), {200}, 0);
  EXPECT_GT(numbers, 10);
}

class ConstrainedContract : public SolverContract {};

TEST_P(ConstrainedContract, FindsAFeasiblePointNearTheConstrainedOptimum) {
  const Problem problem = disc();
  // With 1000 evaluations dynFWA gets to its seventh generation only.
  const RunRecord record = run(problem, solver(), {solver().stochastic ? 5000 : 1000}, 0);
  EXPECT_EQ(record.trace.back().true_values.violation, 0.0);
  EXPECT_GE(record.trace.back().true_values.objective, -std::sqrt(2.0) - constraint_tolerance);
  EXPECT_LT(record.trace.back().true_values.objective, solver().stochastic ? -1.3 : -1.39);
}

TEST_P(SolverContract, GivesTheSameTracesInTwoThreads) {
  const auto work = [this](int number) {
    std::vector<RunRecord> records;
    for (int repeat = 0; repeat < 3; ++repeat) {
      for (const Problem& problem : {easy(), disc()}) {
        if (solver().accepts(problem)) {
          records.push_back(run(problem, solver(), {150}, number + repeat));
        }
      }
    }
    return records;
  };
  auto one = std::async(std::launch::async, work, 1);
  auto two = std::async(std::launch::async, work, 2);
  const std::vector<RunRecord> parallel[] = {one.get(), two.get()};
  for (const int number : {1, 2}) {
    const std::vector<RunRecord> serial = work(number);
    const std::vector<RunRecord>& other = parallel[number - 1];
    ASSERT_EQ(serial.size(), other.size());
    for (std::size_t k = 0; k < serial.size(); ++k) expect_same_trace(serial[k], other[k]);
  }
}

TEST_P(SolverContract, RunsOnTheCarrierTrack) {
  using namespace carrier_track;
  const Machine machine = machine_of(find_case("C1"), exploratory_scene());
  int runs = 0;
  for (const Problem& stated : {count_problem(machine), top_speed_problem(machine)}) {
    for (const Problem& problem : {stated, stated.formulated({stated.smoothing})}) {
      if (!solver().accepts(problem)) continue;
      ++runs;
      const RunRecord record = run(problem, solver(), {100}, 0);
      EXPECT_EQ(record.failure, "") << problem.name;
      EXPECT_EQ(record.termination_reason, TerminationReason::evaluations) << problem.name;
      EXPECT_LE(record.ledger.charged, 100) << problem.name;
      EXPECT_FALSE(record.trace.empty()) << problem.name;
    }
  }
  // They want two variables, or residuals.
  const std::set<std::string> others = {"nlopt-bobyqa",        "nlopt-mlsl-bobyqa",
                                        "nlopt-auglag-bobyqa", "ceres-trust-region",
                                        "tao-pounders",        "tao-brgn"};
  EXPECT_EQ(runs == 0, others.contains(solver().name));
}

std::vector<Solver> solvers_that_accept(const Problem& problem) {
  std::vector<Solver> accepting;
  for (Solver& solver : all_solvers()) {
    if (solver.accepts(problem)) accepting.push_back(std::move(solver));
  }
  return accepting;
}

std::string name_of(const testing::TestParamInfo<Solver>& tested) {
  return test_name(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(Of, SolverContract, testing::ValuesIn(all_solvers()), name_of);
INSTANTIATE_TEST_SUITE_P(Of, PlaneContract, testing::ValuesIn(solvers_that_accept(half_a_number())),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Of, ConstrainedContract, testing::ValuesIn(solvers_that_accept(disc())),
                         name_of);

}  // namespace
}  // namespace ricochet
