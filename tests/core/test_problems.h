#pragma once

#include <cmath>

#include "ricochet/problem.h"

namespace ricochet {

/// Sum of (x_i - 0.25)^2 on [0, 1]^n, with derivatives and residuals; the optimum value is 0.
inline Problem parabola(Eigen::Index n) {
  Problem problem;
  problem.name = "parabola";
  problem.source = "sum of (x_i - 1/4)^2";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = Vector::Constant(n, 0.5);
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(n, 0.25);
  problem.evaluate = [](const Vector& x) { return Values{(x.array() - 0.25).square().sum(), {}}; };
  problem.differentiate = [n](const Vector& x) {
    return Derivatives{
        {(x.array() - 0.25).square().sum(), {}}, 2 * (x.array() - 0.25), Matrix(0, n)};
  };
  problem.residuals = [n](const Vector& x) {
    return Residuals{std::sqrt(2.0) * (x.array() - 0.25), std::sqrt(2.0) * Matrix::Identity(n, n)};
  };
  return problem;
}

}  // namespace ricochet
