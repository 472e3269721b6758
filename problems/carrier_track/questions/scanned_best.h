#pragma once

#include "problems/carrier_track/questions/best_known.h"
#include "src/core/question.h"

/// The best value of a question of one variable, by looking everywhere.
namespace ricochet::carrier_track::inline questions {

/// The best truth of a problem of one variable: of all multiples of the step in its box the lowest
/// best, then moved on by bisection, to 1e-7, where a better point lies within a step, and on from
/// there where one lies up to ten steps away. Infinite, without a point, where no such multiple is
/// feasible.
BestKnown scan_for_best(const Problem& problem, double step);

/// The question with the best value and point that a scan by its own step finds; without any where
/// nothing is feasible. Throws std::invalid_argument for a question of several variables.
Question with_scanned_best(Question question);

}  // namespace ricochet::carrier_track::inline questions
