#pragma once

#include <cstdint>

#include "problems/carrier_track/problems/scanned_best.h"
#include "ricochet/problem.h"

namespace ricochet::studies::best_values {

using carrier_track::BestKnown;
using carrier_track::scan_for_best;

/// Effort for a best value, in evaluations instead of seconds, so that results are reproducible.
struct Effort {
  std::int64_t evaluations = 1500;             ///< of each run of a solver
  std::int64_t evaluations_per_variable = 40;  ///< added for each variable
};

/// Returns the best true objective that several solvers find on a problem of several variables:
/// those without derivatives use the original problem, those with derivatives the surrogates of
/// several smoothing parameters, and local solvers start from the best point. Constraints are
/// penalised for solvers that take none.
BestKnown search_for_best(const Problem& problem, const Effort& effort);

/// Scans a problem of one variable at its step; uses solvers for several variables.
BestKnown best_of(const Problem& problem, const Effort& effort);

}  // namespace ricochet::studies::best_values
