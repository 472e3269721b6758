#include "problems/classic/benchmark.h"
#include "problems/classic/least_squares_functions.h"

namespace ricochet::classic {

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
