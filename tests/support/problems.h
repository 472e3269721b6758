#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "tests/support/numbers.h"

/// Small problems, whose optimum is known.
namespace ricochet {

/// A solver's name as GoogleTest takes it.
inline std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// How a failed test names its solver.
inline void PrintTo(const Solver& solver, std::ostream* stream) {
  *stream << solver.name;
}

/// An unconstrained problem of n variables on [lower, upper]^n, started at `start` everywhere.
/// Without derivatives.
template <class Objective>
Problem box_problem(std::string name, Eigen::Index n, double lower, double upper, double start,
                    Objective objective) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "the tests";
  problem.lower = Vector::Constant(n, lower);
  problem.upper = Vector::Constant(n, upper);
  problem.start = Vector::Constant(n, start);
  problem.evaluate = [objective](const Vector& x) { return Values{objective(x), {}}; };
  return problem;
}

/// Gives a problem a gradient; one with constraints their Jacobian, too.
template <class Gradient>
void differentiate_by(Problem& problem, Gradient gradient,
                      const std::function<Matrix(const Vector&)>& jacobian = {}) {
  problem.differentiate = [evaluate = problem.evaluate, gradient, jacobian](const Vector& x) {
    return Derivatives{evaluate(x), gradient(x), jacobian ? jacobian(x) : Matrix(0, x.size())};
  };
}

/// Gives an unconstrained problem second derivatives.
template <class Hessian>
void curve_by(Problem& problem, Hessian hessian) {
  problem.lagrangian_hessian = [hessian](const Vector& x, double factor,
                                         const Vector& /*multipliers*/) -> Matrix {
    return factor * hessian(x);
  };
}

/// `diagonal` times the unit matrix of this size, wherever.
inline auto constant_hessian(Eigen::Index n, double diagonal) {
  return [n, diagonal](const Vector&) -> Matrix { return diagonal * Matrix::Identity(n, n); };
}

/// Gives a problem a smoothing parameter that changes nothing.
inline Problem with_idle_knob(Problem problem) {
  problem.smoothed = [problem](double) { return problem; };
  return problem;
}

/// sqrt(2) (x_i - centre): half the sum of their squares is the sum of (x_i - centre)^2.
inline Residuals distances(const Vector& x, double centre) {
  return {std::sqrt(2.0) * (x.array() - centre),
          std::sqrt(2.0) * Matrix::Identity(x.size(), x.size())};
}

/// Sum of (x_i - centre)^2 on [lower, upper]^n, with derivatives and residuals; optimum 0.
inline Problem sum_of_squares(const std::string& name, Eigen::Index n, double lower, double upper,
                              double start, double centre) {
  Problem problem = box_problem(name, n, lower, upper, start, [centre](const Vector& x) {
    return (x.array() - centre).square().sum();
  });
  problem.best_known = 0.0;
  differentiate_by(problem,
                   [centre](const Vector& x) -> Vector { return 2 * (x.array() - centre); });
  problem.residuals = [centre](const Vector& x) { return distances(x, centre); };
  return problem;
}

/// The same on [0, 1]^n from the middle, with its best point at 1/4.
inline Problem parabola(Eigen::Index n) {
  Problem problem = sum_of_squares("parabola", n, 0, 1, 0.5, 0.25);
  problem.source = "sum of (x_i - 1/4)^2";
  problem.best_point = Vector::Constant(n, 0.25);
  return problem;
}

/// The same on [-100, 100]^n from 40, with second derivatives.
inline Problem sphere(Eigen::Index n, double centre) {
  Problem problem = sum_of_squares("sphere", n, -100, 100, 40, centre);
  curve_by(problem, constant_hessian(n, 2));
  return with_idle_knob(problem);
}

/// floor(|x - 7|) on [0, 18] from 15: optimum 0 for 6 < x < 8. Its derivative is 0, as is true
/// almost everywhere.
inline Problem staircase() {
  Problem problem = box_problem("staircase", 1, 0, 18, 15,
                                [](const Vector& x) { return std::floor(std::abs(x[0] - 7)); });
  problem.best_known = 0.0;
  differentiate_by(problem, [](const Vector& x) -> Vector { return Vector::Zero(x.size()); });
  return problem;
}

/// As far up [0, 18] as `limit` lets, from 15. Without derivatives.
inline Problem limited(double limit) {
  Problem problem = box_problem("limited", 1, 0, 18, 15, [](const Vector& x) { return -x[0]; });
  problem.constraints = 1;
  problem.best_known = -limit;
  problem.evaluate = [limit](const Vector& x) {
    return Values{-x[0], Vector::Constant(1, x[0] - limit)};
  };
  return problem;
}

/// x + y within the unit disc, on [-2, 2]^2 from outside the disc; optimum -sqrt(2) on the circle.
inline Problem disc() {
  Problem problem = box_problem("disc", 2, -2, 2, 1.5, [](const Vector& x) { return x.sum(); });
  problem.constraints = 1;
  problem.best_known = -std::sqrt(2.0);
  problem.evaluate = [](const Vector& x) {
    return Values{x.sum(), Vector::Constant(1, x.squaredNorm() - 1)};
  };
  differentiate_by(
      problem, [](const Vector&) -> Vector { return Vector::Ones(2); },
      [](const Vector& x) -> Matrix { return 2 * x.transpose(); });
  problem.lagrangian_hessian = [](const Vector&, double, const Vector& multipliers) -> Matrix {
    return 2 * multipliers[0] * Matrix::Identity(2, 2);
  };
  return with_idle_knob(problem);
}

/// x + y on the part of the unit circle where x >= -1/2, on [-2, 2]^2; optimum -(1 + sqrt(3)) / 2
/// at the end of the arc, (-1, -sqrt(3)) / 2. Its first constraint is an equation.
inline Problem arc() {
  Problem problem = disc();
  problem.name = "arc";
  problem.constraints = 2;
  problem.equalities = 1;
  problem.best_known = -(1 + std::sqrt(3.0)) / 2;
  problem.evaluate = [](const Vector& x) {
    return Values{x.sum(), Vector{{x.squaredNorm() - 1, -0.5 - x[0]}}};
  };
  differentiate_by(
      problem, [](const Vector&) -> Vector { return Vector::Ones(2); },
      [](const Vector& x) {
        return Matrix{{2 * x[0], 2 * x[1]}, {-1, 0}};
      });
  return with_idle_knob(problem);
}

/// Stairs on [0, 4] that fall to -3 at 2 and rise again at 2.0105.
inline Problem falling_stairs() {
  return box_problem("stairs", 1, 0, 4, 1,
                     [](const Vector& x) { return x[0] < 2.0105 ? -1.5 * std::floor(x[0]) : 1.0; });
}

/// As far up [0, 4] as it is feasible: below 1.00123, and from 3 to 3.14159265.
inline Problem two_stretches() {
  Problem problem = falling_stairs();
  problem.name = "stretches";
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    const bool feasible = x[0] <= 1.00123 || (x[0] >= 3 && x[0] <= 3.14159265);
    return Values{-x[0], Vector::Constant(1, feasible ? -1.0 : 2.0)};
  };
  return problem;
}

/// The same value, and the same slope, everywhere.
inline Problem flat_problem(const std::string& name, Eigen::Index n, double value, double slope) {
  Problem problem = box_problem(name, n, 0, 18, 9, [value](const Vector&) { return value; });
  differentiate_by(problem,
                   [n, slope](const Vector&) -> Vector { return Vector::Constant(n, slope); });
  curve_by(problem, constant_hessian(n, slope));
  problem.residuals = [n, value, slope](const Vector&) {
    return Residuals{Vector::Constant(1, std::sqrt(2 * value)), Matrix::Constant(1, n, slope)};
  };
  return with_idle_knob(problem);
}
inline Problem plateau(Eigen::Index n) {
  return flat_problem("plateau", n, 7, 0);
}
inline Problem never_a_number(Eigen::Index n) {
  return flat_problem("never-a-number", n, quiet_nan, quiet_nan);
}

/// sphere(2, 3), but no number in the half where the coordinates' sum is above 60, the start
/// included.
inline Problem half_a_number() {
  const auto centre = [](const Vector& x) { return x.sum() > 60 ? quiet_nan : 3; };
  Problem problem = sphere(2, 3);
  problem.name = "half-a-number";
  problem.best_known.reset();
  problem.evaluate = [centre](const Vector& x) {
    return Values{(x.array() - centre(x)).square().sum(), {}};
  };
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * (x.array() - 3); });
  problem.residuals = [centre](const Vector& x) { return distances(x, centre(x)); };
  return with_idle_knob(problem);
}

/// sphere(n, 3) that throws "broken scene" after `calls` calls; for one run.
inline Problem breaks_after(int calls, Eigen::Index n) {
  Problem problem = sphere(n, 3);
  problem.name = "breaks";
  const auto left = std::make_shared<std::atomic<int>>(calls);
  const auto breaking = [left](const auto& function) {
    return [left, function](const auto&... arguments) {
      if (left->fetch_sub(1) <= 0) throw std::runtime_error("broken scene");
      return function(arguments...);
    };
  };
  problem.true_values = [evaluate = problem.evaluate](const Vector& x) {
    return true_values_of(evaluate(x));
  };
  problem.evaluate = breaking(problem.evaluate);
  problem.differentiate = breaking(problem.differentiate);
  problem.lagrangian_hessian = breaking(problem.lagrangian_hessian);
  problem.residuals = breaking(problem.residuals);
  return with_idle_knob(problem);
}

}  // namespace ricochet
