#pragma once

#include <vector>

#include "ricochet/problem.h"

namespace ricochet::classic {

/// The 53 nonlinear least-squares problems of More and Wild, Benchmarking derivative-free
/// optimization algorithms (2009), doi 10.1137/080724083, in their order, named
/// "least-squares-<01..53>-<function>-<n>x<residuals>"; "-far" marks a standard start times 10.
/// They publish the sum of squares; the objective here is half of it. They are unconstrained: every
/// box extends beyond start and optimum by ten times their size, at least by 10. Exceptions, where
/// functions would overflow or lose their meaning, are stated at the function.
std::vector<Problem> least_squares_problems();

}  // namespace ricochet::classic
