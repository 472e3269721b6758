#pragma once

#include "ricochet/problem.h"
#include "src/core/difference.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {

/// x0^2 + x1 subject to 1 - x0^2 x1 <= 0 and x1^2 - 2 <= 0.
inline Problem constrained() {
  Problem problem = box_problem("constrained", 2, -5, 5, 0, [](const Vector&) { return 0.0; });
  problem.constraints = 2;
  problem.best_known = -4.0;
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] * x[0] + x[1], Vector{{1 - x[0] * x[0] * x[1], x[1] * x[1] - 2}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector{{2 * x[0], 1.0}},
                       Matrix{{-2 * x[0] * x[1], -x[0] * x[0]}, {0.0, 2 * x[1]}}};
  };
  problem.lagrangian_hessian = [](const Vector& x, double factor, const Vector& multipliers) {
    const double mixed = -2 * x[0] * multipliers[0];
    return Matrix{{2 * factor - 2 * x[1] * multipliers[0], mixed}, {mixed, 2 * multipliers[1]}};
  };
  return problem;
}

/// Expects the Hessian of the Lagrangian at x to be that of differences of the exact gradient, with
/// steps of this share of the box and less. Returns how many entries were compared: where the
/// differences disagree with one another, a kink is near, and there is nothing to compare.
inline int expect_hessian_of_gradients(const Problem& problem, const Vector& x,
                                       double objective_factor, const Vector& multipliers,
                                       double share = 1e-3, double tolerance = 1e-6) {
  const Matrix hessian = problem.lagrangian_hessian(x, objective_factor, multipliers);
  EXPECT_EQ(hessian.rows(), x.size()) << problem.name;
  EXPECT_EQ(hessian.cols(), x.size()) << problem.name;
  EXPECT_LE((hessian - hessian.transpose()).cwiseAbs().maxCoeff(),
            1e-12 * (1 + hessian.cwiseAbs().maxCoeff()))
      << problem.name;
  int compared = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto gradient_at = [&](double coordinate) -> Vector {
      Vector near = x;
      near[i] = coordinate;
      const Derivatives d = problem.differentiate(near);
      return objective_factor * d.gradient + d.jacobian.transpose() * multipliers;
    };
    const auto slopes =
        differences(gradient_at, x[i], share * (problem.upper[i] - problem.lower[i]));
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      const double size = 1e-3 + std::abs(slopes[k].slope);
      if (!(slopes[k].error < 0.1 * tolerance * size)) continue;
      const auto j = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(hessian(i, j), slopes[k].slope, tolerance * size)
          << problem.name << " " << i << " " << j;
      ++compared;
    }
  }
  return compared;
}

}  // namespace ricochet
