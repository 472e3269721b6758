#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/benchmark.h"
#include "problems/classic/least_squares_functions.h"

namespace ricochet::classic {

Problem rosenbrock_residuals(double scale) {
  return least_squares({.name = "rosenbrock",
                        .origin = more_garbow_hillstrom(1),
                        .start = Vector{{-1.2, 1}},
                        .best_sum = 0,
                        .best_point = Vector{{1, 1}},
                        .provenance = all_zero},
                       scale, []<class Scalar>(const Point<Scalar>& x) {
                         return std::array<Scalar, 2>{10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]};
                       });
}

Problem helical_valley(double scale) {
  return least_squares(
      {.name = "helical-valley",
       .origin = more_garbow_hillstrom(7),
       .start = Vector{{-1, 0, 0}},
       .best_sum = 0,
       .best_point = Vector{{1, 0, 0}},
       .provenance = all_zero},
      scale, []<class Scalar>(const Point<Scalar>& x) {
        using std::atan2;
        using std::sqrt;
        // The angle in turns, from -1/4 to 3/4; it jumps at x_1 = 0, x_2 < 0.
        const Scalar turns = 0.25 - atan2(x[0], x[1]) / (2 * std::numbers::pi);
        const Scalar radius = sqrt(x[0] * x[0] + x[1] * x[1]);
        return std::array<Scalar, 3>{10.0 * (x[2] - 10.0 * turns), 10.0 * (radius - 1.0), x[2]};
      });
}

Problem powell_singular_residuals(double scale) {
  return least_squares({.name = "powell-singular",
                        .origin = more_garbow_hillstrom(13),
                        .start = Vector{{3, -1, 0, 1}},
                        .best_sum = 0,
                        .best_point = Vector::Zero(4),
                        .provenance = all_zero},
                       scale, []<class Scalar>(const Point<Scalar>& x) {
                         const Scalar a = x[1] - 2.0 * x[2];
                         const Scalar b = x[0] - x[3];
                         return std::array<Scalar, 4>{x[0] + 10.0 * x[1],
                                                      std::sqrt(5.0) * (x[2] - x[3]), a * a,
                                                      std::sqrt(10.0) * b * b};
                       });
}

Problem freudenstein_roth(double scale) {
  // There is a second minimum of 48.98 near (11.41, -0.897), at which most solvers end.
  return least_squares({.name = "freudenstein-roth",
                        .origin = more_garbow_hillstrom(2),
                        .start = Vector{{0.5, -2}},
                        .best_sum = 0,
                        .best_point = Vector{{5, 4}},
                        .provenance = all_zero},
                       scale, []<class Scalar>(const Point<Scalar>& x) {
                         const Scalar& y = x[1];
                         return std::array<Scalar, 2>{x[0] - 13.0 + ((5.0 - y) * y - 2.0) * y,
                                                      x[0] - 29.0 + ((y + 1.0) * y - 14.0) * y};
                       });
}

Problem heart_8(double scale) {
  return least_squares(
      {.name = "heart-8",
       .origin = cuter,
       .start = Vector{{-0.3, -0.39, 0.3, -0.344, -1.2, 2.69, 1.59, -1.5}},
       .best_sum = 0,
       .best_point = Vector{{-0.311626605565399, -0.37837339443458845, 0.3282442301180765,
                             -0.3722442301180588, -1.282227094270286, 2.4943003120854743,
                             1.5548658787873983, -1.384637842863253}},
       .provenance = published},
      scale, []<class Scalar>(const Point<Scalar>& x) {
        // In terms of the complex pairs p = (x_1 + i x_3, x_2 + i x_4) and z = (x_5 + i x_7, x_6 +
        // i x_8), the sums of p, p z, p z^2 and p z^3 are given.
        constexpr double real[] = {-0.69, -1.57, -2.65, -12.6};
        constexpr double imaginary[] = {-0.044, -1.31, 2.0, 9.48};
        Point<Scalar> r(8);
        for (int power = 0; power < 4; ++power) {
          r[2 * power] = Scalar(-real[power]);
          r[2 * power + 1] = Scalar(-imaginary[power]);
        }
        for (int k = 0; k < 2; ++k) {
          Scalar a = x[k];
          Scalar b = x[k + 2];
          for (int power = 0; power < 4; ++power) {
            r[2 * power] += a;
            r[2 * power + 1] += b;
            const Scalar next = a * x[k + 4] - b * x[k + 6];
            b = a * x[k + 6] + b * x[k + 4];
            a = next;
          }
        }
        return r;
      });
}

}  // namespace ricochet::classic
