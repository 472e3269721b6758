#include "problems/classic/least_squares.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/classic.h"

namespace ricochet::classic {

std::vector<Problem> least_squares_problems() {
  std::vector<Problem> problems = {
      linear_full_rank(9, 45, 1),
      linear_full_rank(9, 45, 10),
      linear_rank_1(7, 35, 1),
      linear_rank_1(7, 35, 10),
      linear_rank_1_with_zeros(7, 35, 1),
      linear_rank_1_with_zeros(7, 35, 10),
      rosenbrock_residuals(1),
      rosenbrock_residuals(10),
      helical_valley(1),
      helical_valley(10),
      powell_singular_residuals(1),
      powell_singular_residuals(10),
      freudenstein_roth(1),
      freudenstein_roth(10),
      bard(1),
      bard(10),
      kowalik_osborne(),
      meyer(),
      watson(6, 1),
      watson(6, 10),
      watson(9, 1),
      watson(9, 10),
      watson(12, 1),
      watson(12, 10),
      box_3d(),
      jennrich_sampson(),
      brown_dennis(1),
      brown_dennis(10),
      chebyquad(6),
      chebyquad(7),
      chebyquad(8),
      chebyquad(9),
      chebyquad(10),
      chebyquad(11),
      brown_almost_linear(10),
      osborne_1(),
      osborne_2(1),
      osborne_2(10),
      bdqrtic(8),
      bdqrtic(10),
      bdqrtic(11),
      bdqrtic(12),
      cube(5),
      cube(6),
      cube(8),
      mancino(5, 1),
      mancino(5, 10),
      mancino(8, 1),
      mancino(10, 1),
      mancino(12, 1),
      mancino(12, 10),
      heart_8(1),
      heart_8(10),
  };
  int number = 0;
  for (Problem& problem : problems) {
    problem.name = fmt::format("least-squares-{:02}-{}", ++number, problem.name);
  }
  return problems;
}

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

Problem linear_full_rank(Eigen::Index n, Eigen::Index m, double scale) {
  return least_squares({.name = "linear-full-rank",
                        .origin = more_garbow_hillstrom(32),
                        .start = Vector::Ones(n),
                        .best_sum = static_cast<double>(m - n),
                        .best_point = Vector::Constant(n, -1),
                        .provenance = "closed form: m - n, where all x_i are -1"},
                       scale, [m]<class Scalar>(const Point<Scalar>& x) {
                         const Scalar shared = 2.0 / static_cast<double>(m) * x.sum() + 1.0;
                         Point<Scalar> r = Point<Scalar>::Constant(m, -shared);
                         r.head(x.size()) += x;
                         return r;
                       });
}

Problem linear_rank_1(Eigen::Index n, Eigen::Index m, double scale) {
  const auto count = static_cast<double>(m);
  // Only the sum of j x_j matters; this is the point of least norm with the best sum.
  const Vector weights = Vector::LinSpaced(n, 1, static_cast<double>(n));
  const Vector best = 3 / (2 * count + 1) / weights.squaredNorm() * weights;
  return least_squares({.name = "linear-rank-1",
                        .origin = more_garbow_hillstrom(33),
                        .start = Vector::Ones(n),
                        .best_sum = count * (count - 1) / (2 * (2 * count + 1)),
                        .best_point = best,
                        .provenance = "closed form: where the sum of j x_j is 3 / (2 m + 1)"},
                       scale, [weights, m]<class Scalar>(const Point<Scalar>& x) {
                         Scalar sum(0);
                         for (Eigen::Index j = 0; j < x.size(); ++j) sum += weights[j] * x[j];
                         Point<Scalar> r(m);
                         for (Eigen::Index i = 0; i < m; ++i) {
                           r[i] = static_cast<double>(i + 1) * sum - 1.0;
                         }
                         return r;
                       });
}

Problem linear_rank_1_with_zeros(Eigen::Index n, Eigen::Index m, double scale) {
  const auto count = static_cast<double>(m);
  // As above, but without the first and the last variable, and without the first and last row.
  Vector weights = Vector::LinSpaced(n, 1, static_cast<double>(n));
  weights[0] = weights[n - 1] = 0;
  const Vector best = 3 / (2 * count - 3) / weights.squaredNorm() * weights;
  return least_squares(
      {.name = "linear-rank-1-with-zeros",
       .origin = more_garbow_hillstrom(34),
       .start = Vector::Ones(n),
       .best_sum = (count * (count + 3) - 6) / (2 * (2 * count - 3)),
       .best_point = best,
       .provenance = "closed form: where the sum of j x_j, 1 < j < n, is 3 / (2 m - 3)"},
      scale, [weights, m]<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        for (Eigen::Index j = 0; j < x.size(); ++j) sum += weights[j] * x[j];
        Point<Scalar> r(m);
        for (Eigen::Index i = 0; i + 1 < m; ++i) r[i] = static_cast<double>(i) * sum - 1.0;
        r[m - 1] = Scalar(-1);
        return r;
      });
}

}  // namespace ricochet::classic
