#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"

namespace ricochet {

/// The point that a run returns, and its score.
struct ReturnedPoint {
  Vector x;
  TrueValues true_values;
};

/// The record of one run of one solver on one instance of a problem.
struct RunRecord {
  std::string problem;
  std::string solver;
  int instance = 0;
  int run = 0;
  std::uint64_t seed = 0;
  Budget budget;
  Ledger ledger;
  TerminationReason termination_reason = TerminationReason::none;
  std::vector<SolverTermination> terminations;  ///< one for each start
  /// Of the points that the starts returned, the one with the best values in this formulation;
  /// empty if there is none.
  std::optional<ReturnedPoint> returned;
  std::string failure;             ///< what the problem or the solver threw; empty if nothing
  std::vector<Improvement> trace;  ///< see Improvement
};

/// Runs the solver from the problem's start, or from a uniform one if the problem has no
/// start_scales and `number` is not 0. Then restarts it from points uniform in the box until the
/// budget is spent, ten starts in a row evaluate nothing new, or something throws. The starts
/// depend only on problem, instance and number, so that all solvers get the same ones; the solver's
/// randomness depends on the solver too. An exception ends the run and is recorded, not rethrown.
/// `on_improvement`, if not empty, is called at once for every point of the trace. `shown` goes
/// into the seed of the solver: see seed_of. The caller checks whether the solver accepts the
/// problem.
RunRecord run(const Problem& problem, const Solver& solver, const Budget& budget, int number,
              std::function<void(const Improvement&)> on_improvement = nullptr,
              std::string_view shown = {});

/// The record of a run that has not begun.
RunRecord nothing_run(const Problem& problem, const Solver& solver, const Budget& budget,
                      int number, std::string_view shown = {});

/// The score of a run: of its best evaluated point and of the point that it returned, which may be
/// worse.
struct Verdict {
  bool feasible = false;                 ///< a feasible point was evaluated
  std::optional<double> objective;       ///< best true objective among feasible points
  std::optional<double> optimality_gap;  ///< objective - best known, if both exist
  bool solved = false;                   ///< optimality gap <= tolerance
  std::optional<std::int64_t> evaluations_to_solve;
  std::optional<double> seconds_to_solve;
  /// The optimality gap of the returned point; empty if it is infeasible or there is none.
  std::optional<double> returned_optimality_gap;
  bool returned_solved = false;
};

/// `tolerance`: the largest optimality gap, >= 0, that counts as solved. Without a best known value
/// a run has no optimality gap and is not solved.
Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance);
Verdict judge(const RunRecord& record, const Problem& problem, double tolerance);

}  // namespace ricochet
