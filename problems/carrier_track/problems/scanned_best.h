#pragma once

#include "problems/carrier_track/problems/best_known.h"
#include "problems/searched_problem.h"
#include "ricochet/problem.h"

/// The best value of a problem of one variable, by exhaustive scan.
namespace ricochet::carrier_track::inline problems {

/// The best true objective of a problem of one variable: the best (on a tie the lowest) multiple of
/// the step in its box, improved by bisection, to 1e-7, if a better point lies within a step, and
/// repeated from any better point up to ten steps away. Infinite, without a point, if no feasible
/// point is found.
BestKnown scan_for_best(const Problem& problem, double step);

/// The "best_point" found by a scan with the problem's scan_step; empty if no point is feasible.
/// Throws std::invalid_argument for a problem of several variables.
Findings scanned_best(const Problem& problem);

/// The problem with these findings' best point and its value.
Problem with_scanned_best(Problem problem, const Findings& found);

}  // namespace ricochet::carrier_track::inline problems
