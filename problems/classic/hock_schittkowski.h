#pragma once

#include <vector>

#include "ricochet/problem.h"

/// The 116 test problems of Hock and Schittkowski, Test Examples for Nonlinear Programming Codes
/// (1981), doi 10.1007/978-3-642-48320-2, "hs-<number>", with their numbers (82, 94 and 115 do not
/// exist), bounds and starts. Bounds are the box's; if the source has none, the box is wide enough
/// to contain the start and to keep the optimum. Inequalities, >= 0 in the source, are negated, and
/// equations come first. A start outside its own bounds is moved to the nearest point within.
namespace ricochet::classic {

/// All of them, in the order of their numbers.
std::vector<Problem> hock_schittkowski_problems();

/// Problems on Rosenbrock's valley.
std::vector<Problem> hock_schittkowski_valley();

/// The others with two variables.
std::vector<Problem> hock_schittkowski_2();

/// Of three variables.
std::vector<Problem> hock_schittkowski_3();

/// Of four variables.
std::vector<Problem> hock_schittkowski_4();

/// Of five variables.
std::vector<Problem> hock_schittkowski_5();

/// Of six and seven variables.
std::vector<Problem> hock_schittkowski_6();

/// Of eight variables and more.
std::vector<Problem> hock_schittkowski_8();

/// Fits to data.
std::vector<Problem> hock_schittkowski_fits();

/// Plants of the chemical industry.
std::vector<Problem> hock_schittkowski_plants();

/// Electrical networks.
std::vector<Problem> hock_schittkowski_networks();

/// A convex problem and its dual.
std::vector<Problem> hock_schittkowski_dual();

/// The control of heat.
std::vector<Problem> hock_schittkowski_heat();

/// Geometric programs.
std::vector<Problem> hock_schittkowski_geometric();

}  // namespace ricochet::classic
