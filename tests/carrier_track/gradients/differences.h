#pragma once

#include "ricochet/problem.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {

/// Expects the derivatives of a problem at x to be those of its values, by central differences of a
/// step that is this share of the box.
inline void expect_derivatives_of_values(const Problem& problem, const Vector& x, double share,
                                         double tolerance) {
  const Derivatives d = problem.differentiate(x);
  const Values here = problem.evaluate(x);
  EXPECT_NEAR(d.values.objective, here.objective, 1e-9) << problem.name;
  ASSERT_EQ(d.jacobian.rows(), problem.constraints);
  ASSERT_EQ(d.jacobian.cols(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double h = share * (problem.upper[i] - problem.lower[i]);
    Vector up = x;
    Vector down = x;
    up[i] += h;
    down[i] -= h;
    const Values above = problem.evaluate(up);
    const Values below = problem.evaluate(down);
    const double slope = (above.objective - below.objective) / (2 * h);
    EXPECT_NEAR(d.gradient[i], slope, tolerance * (1 + std::abs(slope)))
        << problem.name << " " << i;
    if (problem.constraints == 0) continue;
    EXPECT_NEAR(d.values.constraints[0], here.constraints[0], 1e-9) << problem.name;
    const double rise = (above.constraints[0] - below.constraints[0]) / (2 * h);
    EXPECT_NEAR(d.jacobian(0, i), rise, tolerance * (1 + std::abs(rise)))
        << problem.name << " " << i;
  }
}

}  // namespace ricochet::carrier_track
