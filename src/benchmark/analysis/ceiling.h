#pragma once

#include <optional>

#include "ricochet/problem.h"

namespace ricochet::comparison {

/// Surrogate bias: the optimum of a surrogate, scored on the true objective. No solver that follows
/// the surrogate to its optimum does better.
struct Ceiling {
  double optimum;                        ///< the surrogate's, in the problem's variable
  double distance;                       ///< from the optimum to the best known point
  std::optional<double> optimality_gap;  ///< nothing if the optimum is truly infeasible
};

/// Found by a scan with ten times the problem's scan step, then Brent's method around the best
/// point. Nothing for a problem of several variables, or without a surrogate or a best point.
std::optional<Ceiling> ceiling(const Problem& problem, double smoothing);

}  // namespace ricochet::comparison
