#pragma once

#include <cstdint>

#include "ricochet/problem.h"
#include "ricochet/solver.h"

namespace ricochet::studies::calibration {

/// The best point so far of a problem whose objective is a loss.
struct BestPoint {
  Vector x;
  double loss;
};

/// The problem's start.
BestPoint start_of(const Problem& problem);

/// Runs a solver from the best point, which becomes the problem's start, and keeps an improvement.
/// Throws std::runtime_error if the run failed.
void improve(Problem& problem, const Solver& solver, std::int64_t evaluations, BestPoint& best);

}  // namespace ricochet::studies::calibration
