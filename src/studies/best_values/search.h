#pragma once

#include <cstdint>

#include "problems/carrier_track/questions/scanned_best.h"
#include "src/core/question.h"

namespace ricochet::studies::best_values {

using carrier_track::BestKnown;
using carrier_track::scan_for_best;

/// How much is done for a best value. Evaluations, not seconds: the same comes out again.
struct Effort {
  std::int64_t evaluations = 1500;             ///< of each run of a solver
  std::int64_t evaluations_per_variable = 40;  ///< and so many more for each variable
};

/// The best truth that several solvers find of a question of several variables: those without
/// derivatives on it as stated, those with derivatives on it smoothed by several widths, and local
/// ones from the best point on. Constraints are penalised for those that take none.
BestKnown search_for_best(const Question& question, const Effort& effort);

/// Of one variable by a scan of the question's step, of several by the solvers.
BestKnown best_of(const Question& question, const Effort& effort);

}  // namespace ricochet::studies::best_values
