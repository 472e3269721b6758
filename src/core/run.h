#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/core/evaluator.h"
#include "src/core/solver.h"

namespace ricochet {

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
  std::string failure;            ///< what the problem or the solver threw; empty if nothing
  std::vector<Improvement> trace;
};

/// Runs the solver from the problem's start, and from new starts uniform in the box until the
/// budget is spent, ten starts in a row ask for nothing new, or something throws. The starts depend
/// on problem, instance and run alone, so that all solvers get the same ones; the solver's
/// randomness depends on the solver too. An exception ends the run and is recorded, never passed
/// on.
RunRecord run(const Problem& problem, const Solver& solver, const Budget& budget, int number);

}  // namespace ricochet
