#pragma once

#include <span>

#include "ricochet/problem.h"

namespace ricochet::fireworks {

/// The values of a point, made comparable: an objective or a violation that is not a number below
/// 1e300 in size becomes infinite.
TrueValues worth_of(const Values& values, Eigen::Index equalities);

/// Numbers that rank points, for operators that need differences. A feasible point has its
/// objective. An infeasible one has the objective of the worst feasible point (0 if there is none)
/// plus its violation: the penalty without a parameter (Deb, Computer Methods in Applied Mechanics
/// and Engineering 186 (2000) 311, doi 10.1016/S0045-7825(99)00389-8). An infinite worth counts as
/// the worst finite one; if none is finite, all numbers are 0.
Vector fitness_of(std::span<const TrueValues> worths);

}  // namespace ricochet::fireworks
