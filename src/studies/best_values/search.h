#pragma once

#include <cstdint>

#include "problems/carrier_track/questions/best_known.h"
#include "src/core/question.h"

namespace ricochet::studies::best_values {

using carrier_track::BestKnown;

/// How much is done for a best value. Evaluations, not seconds: the same comes out again.
struct Effort {
  std::int64_t evaluations = 1500;             ///< of each run of a solver
  std::int64_t evaluations_per_variable = 40;  ///< and so many more for each variable
};

/// The best truth of a problem of one variable: of all multiples of the step in its box the lowest
/// best, then moved on by bisection, to 1e-7, where a better point lies within a step.
BestKnown scan_for_best(const Problem& problem, double step);

/// The best truth that several solvers find of a question of several variables: those without
/// derivatives on it as stated, those with derivatives on it smoothed by several widths, and local
/// ones from the best point on. Constraints are penalised for those that take none.
BestKnown search_for_best(const Question& question, const Effort& effort);

/// The one or the other.
BestKnown best_of(const Question& question, const Effort& effort);

}  // namespace ricochet::studies::best_values
