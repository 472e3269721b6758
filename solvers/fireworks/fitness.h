#pragma once

#include <span>

#include "src/core/problem.h"

namespace ricochet::fireworks {

/// What a point is shown to be worth, so that any two can be compared: an objective that is not a
/// number below 1e300 in size becomes infinite, and so does such a violation.
Truth worth_of(const Values& values, Eigen::Index equalities);

/// Numbers that rank points, for operators that need differences. A feasible point has its
/// objective, an infeasible one that of the worst feasible point, or 0 where there is none, plus
/// its violation: the penalty without a parameter (Deb, Computer Methods in Applied Mechanics and
/// Engineering 186 (2000) 311, doi 10.1016/S0045-7825(99)00389-8). An infinite worth counts as the
/// worst finite one; all numbers are 0 where none is finite.
Vector fitness_of(std::span<const Truth> worths);

}  // namespace ricochet::fireworks
