#pragma once

#include <utility>

#include "problems/carrier_track/gradients/derivatives.h"
#include "ricochet/problem.h"

/// Problems whose values and derivatives come from functions of derivatives.h.
namespace ricochet::carrier_track::inline problems {

namespace detail {

/// `factor` times the second derivatives of f at x, in blocks of the size that is fastest for n.
template <class Function>
Matrix curvature(const Function& f, const Vector& x, double factor) {
  if (factor == 0) return Matrix::Zero(x.size(), x.size());
  constexpr int room = Function::jet_size == 1 ? 1 : 2;
  return factor * hessian_of<room>(f, x).hessian;
}

}  // namespace detail

/// Sets this objective, with its exact derivatives if `derivatives`.
template <class Function>
void define(Problem& problem, const Function& objective, bool derivatives) {
  problem.evaluate = [objective](const Vector& x) { return Values{value_of(objective, x), {}}; };
  if (!derivatives) return;
  const Vector widths = problem.upper - problem.lower;
  problem.differentiate = [objective, widths](const Vector& x) {
    Gradient g = gradient_of<Function::jet_size>(objective, x, widths);
    return Derivatives{{g.value, {}}, std::move(g.gradient), Matrix(0, x.size()), g.trust};
  };
  problem.lagrangian_hessian = [objective](const Vector& x, double objective_factor,
                                           const Vector& /*multipliers*/) {
    return detail::curvature(objective, x, objective_factor);
  };
}

/// Sets this objective, which is not simulated, and this constraint, which is simulated and must be
/// <= level.
template <class Objective, class Constraint>
void define(Problem& problem, const Objective& objective, const Constraint& constraint,
            double level, bool derivatives) {
  problem.constraints = 1;
  problem.evaluate = [objective, constraint, level](const Vector& x) {
    return Values{value_of(objective, x), Vector::Constant(1, value_of(constraint, x) - level)};
  };
  if (!derivatives) return;
  const Vector widths = problem.upper - problem.lower;
  problem.differentiate = [objective, constraint, level, widths](const Vector& x) {
    Gradient of_objective = gradient_of<Objective::jet_size>(objective, x, widths);
    const Gradient of_constraint = gradient_of<Constraint::jet_size>(constraint, x, widths);
    return Derivatives{{of_objective.value, Vector::Constant(1, of_constraint.value - level)},
                       std::move(of_objective.gradient),
                       of_constraint.gradient.transpose(),
                       of_constraint.trust};
  };
  problem.lagrangian_hessian = [objective, constraint](const Vector& x, double objective_factor,
                                                       const Vector& multipliers) -> Matrix {
    return detail::curvature(objective, x, objective_factor) +
           detail::curvature(constraint, x, multipliers[0]);
  };
}

/// The problem with the functions that `define_at(problem, smoothing parameter)` sets for this
/// smoothing parameter; Problem::smoothed sets those of any other. The true objective is that of
/// smoothing parameter 0.
template <class DefineAt>
Problem smoothable(const Problem& frame, const DefineAt& define_at, double smoothing = 0) {
  Problem problem = frame;
  if (smoothing > 0) {
    define_at(problem, 0.0);
    problem.true_values = [evaluate = problem.evaluate](const Vector& x) {
      return true_values_of(evaluate(x));
    };
  }
  define_at(problem, smoothing);
  problem.jumps = smoothing == 0;
  problem.smoothed = [frame, define_at](double other) {
    return smoothable(frame, define_at, other);
  };
  return problem;
}

}  // namespace ricochet::carrier_track::inline problems
