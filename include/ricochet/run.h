#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/improvement.h"
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

}  // namespace ricochet
