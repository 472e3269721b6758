#pragma once

#include "solvers/plateau_search/sight.h"

namespace ricochet::drifting {

/// The point of the unit cube, u + p, where g'p + p'B p / 2 is least, as far as bounds that were
/// met on the way are never left again: returns p. B must be positive definite.
Vector model_step(const Matrix& b, const Vector& g, const Vector& u);

/// A descent of what is shown at a smoothing width by damped BFGS (Powell 1978, doi
/// 10.1007/BFb0067703; Nocedal and Wright, Numerical Optimization, procedure 18.2) over the box,
/// each step the least of the quadratic model within it. Where six shorter and shorter steps are no
/// lower it begins anew from the first B, and where that does not help it takes the shortest one
/// all the same: the surrogate of a count has corners, and one step across is often enough. Ends
/// after 20 steps in a row that gain less than 0.01, or 100 in all. Leaves the lowest point in
/// `u` and returns what was shown there, or nothing once the run is over.
std::optional<double> descend(Sight& sight, Vector& u, std::optional<double> width);

}  // namespace ricochet::drifting
