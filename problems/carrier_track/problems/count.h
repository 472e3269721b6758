#pragma once

#include <vector>

#include "problems/carrier_track/problems/machine.h"
#include "ricochet/problem.h"

/// The speed with the fewest collisions.
namespace ricochet::carrier_track::inline problems {

/// Minimise the collision count over the speed: an integer staircase without derivatives. The
/// smooth surrogate has them.
Problem count_problem(const Machine& machine);

}  // namespace ricochet::carrier_track::inline problems
