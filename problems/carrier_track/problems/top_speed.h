#pragma once

#include <string>

#include "problems/carrier_track/problems/machine.h"
#include "ricochet/problem.h"

/// The fastest quiet speed.
namespace ricochet::carrier_track::inline problems {

/// Minimise -speed subject to count <= quiet limit, without derivatives. The surrogate has them;
/// its constraint is to stay below the half_level of the limit.
Problem top_speed_problem(const Machine& machine);

/// The same problem in another family, whose name is its prefix.
Problem top_speed_problem_of(const std::string& family, const Machine& machine);

}  // namespace ricochet::carrier_track::inline problems
