#pragma once

#include <cstdint>
#include <string>

#include "src/core/problem.h"
#include "src/core/solver.h"
#include "src/studies/trials/trial.h"

namespace ricochet::studies::trials {

/// Who searches, how long, and from which seed on.
struct TrialSearch {
  Solver global;
  Solver local;
  std::int64_t evaluations;  ///< of the misfit, in all
  int seed = 1;
};

/// What a search found.
struct TrialFit {
  TrialConstants constants;
  double misfit;
};

/// The problem of finding the constants of a trial: those of its base that are freed, then its own,
/// each as its place within its bounds, in [0, 1].
Problem trial_problem(const Trial& trial);

/// The constants of a point of that problem.
TrialConstants constants_at(const Trial& trial, const Vector& x);

/// Fits the constants from start_of(trial) on: the global solver has two thirds of the evaluations,
/// the local one the rest; the best point of all counts. The same search gives the same fit.
TrialFit fit(const Trial& trial, const TrialSearch& search);

/// Everything that decides what fit() returns, as a short text.
std::string key_of(const Trial& trial, const TrialSearch& search);

}  // namespace ricochet::studies::trials
