#pragma once

#include "ricochet/problem.h"

/// Functions of n >= 1 variables with many valleys, "classic-<name>-<n>". Boxes and starts as in
/// functions.h.
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

// Functions of n >= 2 variables with one valley, "classic-<name>-<n>". If the usual box has the
// optimum at its centre, its lower end is moved to 3/5 of the way, because a solver that begins at
// the centre would start at the solution. Functions without a usual start begin at 4/5 of every
// width.

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

// Functions of two variables, "classic-<name>". Each doc comment says why the best point of the
// box is best on all of R^2.

/// Sum over k = 1, 2, 3 of (c_k - x (1 - y^k))^2 with c = (1.5, 2.25, 2.625). A sum of squares, 0.
Problem beale();

/// (x + 2 y - 7)^2 + (2 x + y - 5)^2. A sum of squares, 0.
Problem booth();

/// (x^2 + y - 11)^2 + (x + y^2 - 7)^2, with four minima of 0. A sum of squares, 0.
Problem himmelblau();

/// The product of
///   1 + (x + y + 1)^2 (3 s^2 - 14 s + 19), s = x + y, and
///   30 + t^2 (3 t^2 - 16 t + 18), t = 2 x - 3 y.
/// The first factor is least with 1 at s = -1, the second with 3 at t = 3: 3 at (0, -1).
Problem goldstein_price();

/// (y - 5.1 / (4 pi^2) x^2 + 5 / pi x - 6)^2 + 10 (1 - 1 / (8 pi)) cos x + 10. A square that can be
/// 0 for every x, and a cosine that is -1 at x = -pi, pi, 3 pi: 5 / (4 pi).
Problem branin();

/// (4 - 2.1 x^2 + x^4 / 3) x^2 + x y + (4 y^2 - 4) y^2: six minima, two of them global. It is above
/// 0 outside the box, where x^6 / 3 and 4 y^4 dominate.
Problem six_hump_camel();

}  // namespace ricochet::classic
