#pragma once

#include <vector>

#include "src/core/problem.h"

/// Test problems of Hock and Schittkowski, Test Examples for Nonlinear Programming Codes (1981),
/// doi 10.1007/978-3-642-48320-2, "hs-<number>", with their numbers, bounds and starts: 33 of the
/// collection's 116, 6 and 7 with an equation; most of those with equations and about 35 with
/// inequalities alone are missing. Bounds are the box's; where the source has none, the box is wide
/// enough to hold the start and to leave the optimum as it is. Inequalities, there >= 0, are
/// negated. A start that is outside its own bounds (2, 21, 65) is moved to the nearest point
/// within.
namespace ricochet::classic {

/// Those of two variables.
std::vector<Problem> hock_schittkowski_2();

/// Those of three variables.
std::vector<Problem> hock_schittkowski_3();

/// Those of four variables and more.
std::vector<Problem> hock_schittkowski_4();

}  // namespace ricochet::classic
