#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "problems/family.h"

/// The speed with the fewest collisions.
namespace ricochet::carrier_track::inline questions {

/// Minimise the collision count over the speed: an integer staircase, no derivatives.
Problem count_problem(const Machine& machine);

/// The same shown the smooth surrogate, width > 0, with derivatives; judged by the true count.
Problem surrogate_problem(const Machine& machine, double width);

Family count_family(const std::vector<Machine>& machines);
Family surrogate_family(const std::vector<Machine>& machines);

}  // namespace ricochet::carrier_track::inline questions
