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

// The 22 functions of the least-squares benchmark, each from its standard start times `scale`.
// Their names have no number yet: "<function>-<n>x<residuals>".

// Linear in x, with any number m of residuals.
Problem linear_full_rank(Eigen::Index n, Eigen::Index m, double scale);
Problem linear_rank_1(Eigen::Index n, Eigen::Index m, double scale);
Problem linear_rank_1_with_zeros(Eigen::Index n, Eigen::Index m, double scale);

// Systems of few equations.
Problem rosenbrock_residuals(double scale);
Problem helical_valley(double scale);
Problem powell_singular_residuals(double scale);
Problem freudenstein_roth(double scale);
Problem heart_8(double scale);

// Systems of any number of equations.
Problem watson(Eigen::Index n, double scale);  ///< n = 6, 9 or 12
Problem chebyquad(Eigen::Index n);             ///< n = 6 to 11
Problem brown_almost_linear(Eigen::Index n);
Problem bdqrtic(Eigen::Index n);  ///< n = 8, 10, 11 or 12
Problem cube(Eigen::Index n);
Problem mancino(Eigen::Index n, double scale);  ///< n = 5, 8, 10 or 12

// Fits of a model to data.
Problem bard(double scale);
Problem kowalik_osborne();
Problem meyer();
Problem box_3d();
Problem jennrich_sampson();
Problem brown_dennis(double scale);
Problem osborne_1();
Problem osborne_2(double scale);

}  // namespace ricochet::classic
