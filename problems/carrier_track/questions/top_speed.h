#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "problems/family.h"

/// The fastest quiet speed.
namespace ricochet::carrier_track::inline questions {

/// Minimise -speed subject to count <= quiet limit. No derivatives.
Problem top_speed_problem(const Machine& machine);

/// The same shown the surrogate, width > 0, with derivatives, in the constraint: it must stay below
/// the half_level of the limit. Judged by the true count.
Problem top_speed_surrogate_problem(const Machine& machine, double width);

Family top_speed_family(const std::vector<Machine>& machines);
Family top_speed_surrogate_family(const std::vector<Machine>& machines);

}  // namespace ricochet::carrier_track::inline questions
