#pragma once

#include "ricochet/problem.h"

/// Functions of n >= 2 variables with one valley, "classic-<name>-<n>". If the usual box has the
/// optimum at its centre, its lower end is moved to 3/5 of the way, because a solver that begins at
/// the centre would start at the solution. Functions without a usual start begin at 4/5 of every
/// width.
namespace ricochet::classic {

/// Sum of x_i^2.
Problem sphere(Eigen::Index n);

/// Sum of 10^(6 (i - 1) / (n - 1)) x_i^2, i from 1: half-axes from 1 to 1000.
Problem ellipsoid(Eigen::Index n);

/// Sum of 100 (x_{i+1} - x_i^2)^2 + (1 - x_i)^2. For n >= 4 it has a second, local minimum near
/// (-1, 1, ..., 1), with a value of about 4.
Problem rosenbrock(Eigen::Index n);

/// Sum of x_i^2, plus the second and the fourth power of half the sum of i x_i.
Problem zakharov(Eigen::Index n);

/// (x_1 - 1)^2 + sum of i (2 x_i^2 - x_{i-1})^2, i from 2.
Problem dixon_price(Eigen::Index n);

/// Schwefel's problem 1.2: sum over i of (x_1 + ... + x_i)^2.
Problem schwefel_1_2(Eigen::Index n);

/// Powell's singular function; n = 4. Its second derivatives at the optimum are singular.
Problem powell_singular();

/// Sum of floor(x_i + 1/2)^2: integer values and plateaus like a count's, without derivatives.
Problem step(Eigen::Index n);

}  // namespace ricochet::classic
