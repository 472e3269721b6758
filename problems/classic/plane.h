#pragma once

#include "ricochet/problem.h"

/// Functions of two variables, "classic-<name>". Each doc comment says why the best point of the
/// box is best on all of R^2.
namespace ricochet::classic {

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
