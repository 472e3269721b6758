#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/core/evaluator.h"
#include "src/core/solver.h"

namespace ricochet {

/// What a run ends with, in the solver's opinion.
struct HandedOver {
  Vector x;
  Truth truth;
};

/// All that is kept of one run of one solver on one instance of a problem.
struct RunRecord {
  std::string problem;
  std::string solver;
  int instance = 0;
  int run = 0;
  std::uint64_t seed = 0;
  Budget budget;
  Ledger ledger;
  Refusal refusal = Refusal::none;
  std::vector<SolverExit> exits;  ///< one for each start
  /// Of the points that the starts handed over, the best as it was shown; nothing where there is
  /// none.
  std::optional<HandedOver> handed_over;
  std::string failure;  ///< what the problem or the solver threw; empty if nothing
  std::vector<Improvement> trace;
};

/// Runs the solver from the problem's start, or, where that is no part of the problem and the run's
/// number is not 0, from a uniform one; and from new starts uniform in the box until the budget is
/// spent, ten starts in a row ask for nothing new, or something throws. The starts depend
/// on problem, instance and run alone, so that all solvers get the same ones; the solver's
/// randomness depends on the solver too. An exception ends the run and is recorded, never passed
/// on.
/// `on_improvement`, where there is one, is told at once of every point of the trace. `shown` goes
/// into the seed of the solver: see seed_of.
RunRecord run(const Problem& problem, const Solver& solver, const Budget& budget, int number,
              std::function<void(const Improvement&)> on_improvement = nullptr,
              std::string_view shown = {});

/// The record of a run of which nothing has been done yet.
RunRecord nothing_run(const Problem& problem, const Solver& solver, const Budget& budget,
                      int number, std::string_view shown = {});

}  // namespace ricochet
