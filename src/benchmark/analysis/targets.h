#pragma once

#include <vector>

#include "ricochet/problem.h"

namespace ricochet::comparison {

/// The optimality gaps that are the targets of a problem, rising: the first is its tolerance, with
/// which it is solved.
using Targets = std::vector<double>;

/// The optimality gap of a point that costs no search: the median of the true objective at 15
/// random points of the box, the same ones for every solver, less the best known value. Infeasible
/// points count only if all are infeasible; then the size of the gap is taken. Points where the
/// problem throws or is not finite do not count; without any other the result is 0.
double reference_gap(const Problem& problem);

/// The targets between the best known value, which the problem must have, and the reference gap. Of
/// a count, whose tolerance is 1/2, all integer levels: gaps of 1/2, 3/2, ... Otherwise 51 gaps,
/// evenly spaced on a logarithmic scale. The tolerance alone if the reference gap is within it.
Targets targets_of(const Problem& problem);

/// The share of the targets that this optimality gap reaches.
double share_reached(const Targets& targets, double gap);

}  // namespace ricochet::comparison
