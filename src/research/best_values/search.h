#pragma once

#include <cstdint>

#include "problems/carrier_track/problems/scanned_best.h"
#include "ricochet/problem.h"

namespace ricochet::studies::best_values {

using carrier_track::BestKnown;
using carrier_track::scan_for_best;

/// Effort for a best value, in evaluations instead of seconds, so that results are reproducible.
struct Effort {
  /// Of each search: fifty times the largest budget of any plan.
  std::int64_t evaluations_per_variable = 50'000;
  int rounds = 2;  ///< of three searches each; none begins after two agree
};

/// Returns the best true objective of a problem of several variables: by three solvers that do best
/// on such problems, each restarted until its evaluations are spent and improved by local solvers,
/// until two searches end within the problem's tolerance of the best, or all rounds are over.
/// Constraints are penalised for solvers that take none. The problem's best known point stays if no
/// search finds a better one. The provenance says how many searches agree.
BestKnown search_for_best(const Problem& problem, const Effort& effort);

/// Scans a problem of one variable at its step; uses solvers for several variables.
BestKnown best_of(const Problem& problem, const Effort& effort);

}  // namespace ricochet::studies::best_values
