#pragma once

#include "ricochet/problem.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {

/// Expects the derivatives of a problem at x to be those of its values, by central differences of a
/// step that is this share of the box.
inline void expect_derivatives_of_values(const Problem& problem, const Vector& x, double share,
                                         double tolerance) {
  const auto all = [](const Values& values) {
    Vector objective_and_constraints(1 + values.constraints.size());
    objective_and_constraints << values.objective, values.constraints;
    return objective_and_constraints;
  };
  const Derivatives d = problem.differentiate(x);
  EXPECT_LT((all(d.values) - all(problem.evaluate(x))).norm(), 1e-9) << problem.name;
  ASSERT_EQ(d.jacobian.rows(), problem.constraints);
  ASSERT_EQ(d.jacobian.cols(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double h = share * (problem.upper[i] - problem.lower[i]);
    const Vector step = h * Vector::Unit(x.size(), i);
    const Vector slopes =
        (all(problem.evaluate(x + step)) - all(problem.evaluate(x - step))) / (2 * h);
    for (Eigen::Index k = 0; k < slopes.size(); ++k) {
      EXPECT_NEAR(k == 0 ? d.gradient[i] : d.jacobian(k - 1, i), slopes[k],
                  tolerance * (1 + std::abs(slopes[k])))
          << problem.name << " " << k << " " << i;
    }
  }
}

}  // namespace ricochet::carrier_track
