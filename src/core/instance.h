#pragma once

#include "src/core/problem.h"
#include "src/core/random.h"

namespace ricochet {

/// The same problem in other coordinates: every coordinate's box is moved by up to its own width
/// and, on the toss of a coin, reflected; the start is drawn uniformly from the box. What a solver
/// gains from the origin, a corner or the start is chance, and shows as spread over instances. A
/// problem that allows it is also turned about its best point, so that nothing is gained from the
/// axes.
/// Instance 0 is the problem as stated. Deterministic in (problem name, number).
/// Throws std::invalid_argument for number < 0.
Problem instance(const Problem& problem, int number);

/// A point uniform in the problem's box.
Vector uniform_point(const Problem& problem, Random& random);

}  // namespace ricochet
