#pragma once

#include <cmath>

#include "ricochet/problem.h"

namespace ricochet::studies::best_values {

/// Stairs that fall to -3 at 2 and rise again at 2.0105.
inline Problem stairs() {
  Problem problem;
  problem.name = "stairs";
  problem.lower = Vector::Constant(1, 0.0);
  problem.upper = Vector::Constant(1, 4.0);
  problem.start = Vector::Constant(1, 1.0);
  problem.evaluate = [](const Vector& x) {
    return Values{x[0] < 2.0105 ? -1.5 * std::floor(x[0]) : 1.0, {}};
  };
  return problem;
}

/// Fastest, where quiet: below 1.00123, and from 3 to 3.14159265.
inline Problem speeds() {
  Problem problem = stairs();
  problem.name = "speeds";
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    const bool quiet = x[0] <= 1.00123 || (x[0] >= 3 && x[0] <= 3.14159265);
    return Values{-x[0], Vector::Constant(1, quiet ? -1.0 : 2.0)};
  };
  return problem;
}

/// (x - 1)^2 + (y - 2)^2, at most 1 in x + y: 2 at (0, 1); with derivatives.
inline Problem cut_bowl() {
  Problem problem;
  problem.name = "cut-bowl";
  problem.lower = Vector::Constant(2, -4.0);
  problem.upper = Vector::Constant(2, 4.0);
  problem.start = Vector::Constant(2, 3.0);
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{std::pow(x[0] - 1, 2) + std::pow(x[1] - 2, 2),
                  Vector::Constant(1, x[0] + x[1] - 1)};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), 2 * (x - Vector(Eigen::Vector2d(1, 2))), Matrix::Ones(1, 2)};
  };
  return problem;
}

}  // namespace ricochet::studies::best_values
