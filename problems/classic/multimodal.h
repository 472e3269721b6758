#pragma once

#include "ricochet/problem.h"

/// Functions of n >= 1 variables with many valleys, "classic-<name>-<n>". Boxes and starts as in
/// unimodal.h.
namespace ricochet::classic {

/// Sum of 10 + x_i^2 - 10 cos(2 pi x_i).
Problem rastrigin(Eigen::Index n);

/// 20 - 20 exp(-r / 5) + e - exp(mean of cos(2 pi x_i)), r the root of the mean of x_i^2. It has a
/// kink at its optimum; the gradient returned there is 0.
Problem ackley(Eigen::Index n);

/// 1 + sum of x_i^2 / 4000 - product of cos(x_i / sqrt(i)).
Problem griewank(Eigen::Index n);

/// With w_i = 1 + (x_i - 1) / 4: sin^2(pi w_1) + sum for i < n of
/// (w_i - 1)^2 (1 + 10 sin^2(pi w_i + 1)) + (w_n - 1)^2 (1 + sin^2(2 pi w_n)).
Problem levy(Eigen::Index n);

/// Half the sum of x_i^4 - 16 x_i^2 + 5 x_i: 2^n valleys.
Problem styblinski_tang(Eigen::Index n);

/// Schwefel's problem 2.26: minus the sum of x_i sin(sqrt|x_i|). It is unbounded below on R^n.
Problem schwefel_2_26(Eigen::Index n);

/// Hartmann's functions: minus the sum of four Gaussian wells; n = 3 and n = 6.
Problem hartmann_3();
Problem hartmann_6();

/// Shekel's foxholes: minus the sum of ten wells; n = 4.
Problem shekel();

}  // namespace ricochet::classic
