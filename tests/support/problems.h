#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
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

/// Gives an unconstrained problem a gradient.
template <class Gradient>
void differentiate_by(Problem& problem, Gradient gradient) {
  problem.differentiate = [evaluate = problem.evaluate, gradient](const Vector& x) {
    return Derivatives{evaluate(x), gradient(x), Matrix(0, x.size())};
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

/// Sum of (x_i - centre)^2 on [-100, 100]^n from 40; optimum 0 at x_i = centre. With residuals.
inline Problem sphere(Eigen::Index n, double centre) {
  Problem problem = box_problem("sphere", n, -100, 100, 40, [centre](const Vector& x) {
    return (x.array() - centre).square().sum();
  });
  problem.best_known = 0.0;
  differentiate_by(problem,
                   [centre](const Vector& x) -> Vector { return 2 * (x.array() - centre); });
  curve_by(problem, constant_hessian(n, 2));
  problem.residuals = [centre](const Vector& x) { return distances(x, centre); };
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
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector::Ones(2), 2 * x.transpose()};
  };
  problem.lagrangian_hessian = [](const Vector&, double, const Vector& multipliers) -> Matrix {
    return 2 * multipliers[0] * Matrix::Identity(2, 2);
  };
  return with_idle_knob(problem);
}

/// x + y on the part of the unit circle where x >= -1/2, on [-2, 2]^2; optimum -(1 + sqrt(3)) / 2
/// at the end of the arc, (-1, -sqrt(3)) / 2. Its first constraint is an equation.
inline Problem arc() {
  Problem problem = box_problem("arc", 2, -2, 2, 1.5, [](const Vector& x) { return x.sum(); });
  problem.constraints = 2;
  problem.equalities = 1;
  problem.best_known = -(1 + std::sqrt(3.0)) / 2;
  problem.evaluate = [](const Vector& x) {
    return Values{x.sum(), Vector{{x.squaredNorm() - 1, -0.5 - x[0]}}};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector::Ones(2), Matrix{{2 * x[0], 2 * x[1]}, {-1, 0}}};
  };
  problem.lagrangian_hessian = [](const Vector&, double, const Vector& multipliers) -> Matrix {
    return 2 * multipliers[0] * Matrix::Identity(2, 2);
  };
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

/// The same value everywhere.
inline Problem plateau(Eigen::Index n) {
  Problem problem = box_problem("plateau", n, 0, 18, 9, [](const Vector&) { return 7.0; });
  differentiate_by(problem, [](const Vector& x) -> Vector { return Vector::Zero(x.size()); });
  curve_by(problem, constant_hessian(n, 0));
  problem.residuals = [n](const Vector&) {
    return Residuals{Vector::Constant(1, std::sqrt(14.0)), Matrix::Zero(1, n)};
  };
  return with_idle_knob(problem);
}

/// No number anywhere.
inline Problem never_a_number(Eigen::Index n) {
  Problem problem =
      box_problem("never-a-number", n, 0, 18, 9, [](const Vector&) { return quiet_nan; });
  differentiate_by(problem,
                   [](const Vector& x) -> Vector { return Vector::Constant(x.size(), quiet_nan); });
  curve_by(problem, constant_hessian(n, quiet_nan));
  problem.residuals = [n](const Vector&) {
    return Residuals{Vector::Constant(1, quiet_nan), Matrix::Constant(1, n, quiet_nan)};
  };
  return with_idle_knob(problem);
}

/// sphere(2, 3), but no number in the half where the coordinates' sum is above 60, the start
/// included.
inline Problem half_a_number() {
  Problem problem = box_problem("half-a-number", 2, -100, 100, 40, [](const Vector& x) {
    return x.sum() > 60 ? quiet_nan : (x.array() - 3).square().sum();
  });
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * (x.array() - 3); });
  curve_by(problem, constant_hessian(2, 2));
  problem.residuals = [](const Vector& x) { return distances(x, x.sum() > 60 ? quiet_nan : 3); };
  return with_idle_knob(problem);
}

/// sphere(n, 3) that throws "broken scene" after `calls` calls; for one run.
inline Problem breaks_after(int calls, Eigen::Index n) {
  Problem problem = sphere(n, 3);
  problem.name = "breaks";
  const auto left = std::make_shared<std::atomic<int>>(calls);
  const auto step = [left] {
    if (left->fetch_sub(1) <= 0) throw std::runtime_error("broken scene");
  };
  problem.true_values = [evaluate = problem.evaluate](const Vector& x) {
    return true_values_of(evaluate(x));
  };
  problem.evaluate = [step, evaluate = problem.evaluate](const Vector& x) {
    step();
    return evaluate(x);
  };
  problem.differentiate = [step, differentiate = problem.differentiate](const Vector& x) {
    step();
    return differentiate(x);
  };
  problem.lagrangian_hessian = [step, hessian = problem.lagrangian_hessian](
                                   const Vector& x, double factor, const Vector& multipliers) {
    step();
    return hessian(x, factor, multipliers);
  };
  problem.residuals = [step, residuals = problem.residuals](const Vector& x) {
    step();
    return residuals(x);
  };
  return with_idle_knob(problem);
}

/// Sum of (x_i - 0.25)^2 on [0, 1]^n, with derivatives and residuals; the optimum value is 0.
inline Problem parabola(Eigen::Index n) {
  Problem problem = box_problem("parabola", n, 0, 1, 0.5,
                                [](const Vector& x) { return (x.array() - 0.25).square().sum(); });
  problem.source = "sum of (x_i - 1/4)^2";
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(n, 0.25);
  differentiate_by(problem, [](const Vector& x) -> Vector { return 2 * (x.array() - 0.25); });
  problem.residuals = [](const Vector& x) { return distances(x, 0.25); };
  return problem;
}

}  // namespace ricochet
