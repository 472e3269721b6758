#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include "problems/carrier_track/suite/machine.h"
#include "problems/classic/classic.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/evaluator.h"
#include "tests/support/files.h"
#include "tests/support/problems.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

/// Ways to call a solver, and to look at what it did.
namespace ricochet {

inline const TrueValues& best_of(const RunRecord& record) {
  return record.trace.back().true_values;
}

/// The best objective of a run.
inline double end_of(const Problem& problem, const Solver& solver, std::int64_t evaluations,
                     int number = 0) {
  return best_of(run(problem, solver, {evaluations}, number)).objective;
}

/// Where a run improved.
inline std::vector<Vector> points_of(const RunRecord& record) {
  std::vector<Vector> points;
  for (const Improvement& step : record.trace) points.push_back(step.x);
  return points;
}

inline std::vector<std::string> reasons_of(const RunRecord& record) {
  std::vector<std::string> reasons;
  for (const SolverTermination& exit : record.terminations) reasons.push_back(exit.reason);
  return reasons;
}

/// What a single call of `solve`, from the problem's start, came to.
struct Solved {
  std::string reason;
  std::optional<Vector> point;  ///< that it returned
  Ledger ledger;
  TerminationReason ended = TerminationReason::none;  ///< of the evaluator
  std::optional<Improvement> best;
};

inline Solved solved(const Problem& problem, const Solver& solver, std::int64_t evaluations,
                     std::uint64_t seed = Random::default_seed) {
  Scorer scorer(problem);
  Evaluator evaluator(problem, {evaluations}, &scorer);
  Random random(seed);
  const SolverTermination exit = solver.solve(evaluator, problem.start, random);
  return {exit.reason, exit.point, evaluator.ledger(), evaluator.termination_reason(),
          scorer.best() ? std::optional(*scorer.best()) : std::nullopt};
}

/// The problem, which shows `look` every point that it is asked for.
inline Problem watched(const Problem& problem, const std::function<void(const Vector&)>& look) {
  Problem result = problem;
  const auto after_look = [&look](const auto& function) {
    return [=](const Vector& x) { return look(x), function(x); };
  };
  result.evaluate = after_look(problem.evaluate);
  if (problem.differentiate) result.differentiate = after_look(problem.differentiate);
  if (problem.residuals) result.residuals = after_look(problem.residuals);
  result.smoothed = nullptr;
  if (problem.smoothed) result.smoothed = [result](double) { return result; };
  return result;
}

/// Every point that a run asks for, in order.
inline std::vector<Vector> asked_points(const Problem& problem, const Solver& solver,
                                        std::int64_t evaluations, int number = 1) {
  std::vector<Vector> asked;
  run(watched(problem, [&](const Vector& x) { asked.push_back(x); }), solver, {evaluations},
      number);
  return asked;
}

/// Every point that a single call of `solve` asks for, from the problem's start.
inline std::vector<Vector> asked_by_a_start(const Problem& problem, const Solver& solver,
                                            std::int64_t evaluations, std::uint64_t seed) {
  std::vector<Vector> asked;
  const Problem shown = watched(problem, [&](const Vector& x) { asked.push_back(x); });
  Evaluator evaluator(shown, {evaluations});
  Random random(seed);
  solver.solve(evaluator, problem.start, random);
  return asked;
}

inline bool is_in_the_box(const Vector& x, const Problem& problem) {
  return (x.array() >= problem.lower.array()).all() && (x.array() <= problem.upper.array()).all();
}

/// The problem with a box of no width in coordinate 1.
inline Problem with_fixed_coordinate(Problem problem, double at) {
  problem.lower[1] = problem.upper[1] = problem.start[1] = at;
  return problem;
}

/// A problem of the benchmark.
inline Problem suite_problem(const std::string& name) {
  for (const auto& families : {classic::families, carrier_track::case_families}) {
    for (const Family& family : families()) {
      for (const Problem& problem : family.problems) {
        if (problem.name == name) return problem;
      }
    }
  }
  throw std::logic_error("no problem " + name);
}

/// The solvers of the benchmark for which `holds`.
template <class Predicate>
std::vector<Solver> solvers_that(const Predicate& holds) {
  std::vector<Solver> solvers = all_solvers();
  std::erase_if(solvers, [&](const Solver& solver) { return !holds(solver); });
  return solvers;
}

/// Tests of each of some solvers.
class OfSolver : public testing::TestWithParam<Solver> {
 protected:
  const Solver& solver() const { return GetParam(); }
};

/// How a test is named after its solver.
inline constexpr auto by_solver = [](const auto& tested) { return test_name(tested.param.name); };

/// Whether `call` returns true in a copy of this process.
template <class Call>
bool holds_in_a_copy(const Call& call) {
  const pid_t copy = fork();
  if (copy == 0) _exit(call() ? 0 : 1);
  int status = -1;
  waitpid(copy, &status, 0);
  return status == 0;
}

/// Expects that `read` refuses each input, and names it at the beginning of its message.
template <class Read>
void expect_named_refusals(const Read& read, const std::vector<Refusal<std::string>>& refusals) {
  expect_refusals(read, refusals);
  for (const Refusal<std::string>& refused : refusals) {
    EXPECT_THAT(complaint_of([&] { return read(refused.input); }),
                StartsWith(refused.input + ": "));
  }
}

/// An empty folder of this test's own.
inline fs::path fresh_folder() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fmt::format("{}/ricochet_solvers_{}_{}", testing::TempDir(),
                                      test.test_suite_name(), test.name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}  // namespace ricochet
