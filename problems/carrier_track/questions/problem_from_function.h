#pragma once

#include <utility>

#include "problems/carrier_track/gradients/derivatives.h"
#include "src/core/problem.h"

/// The same question, shown to solvers as functions of derivatives.h instead.
namespace ricochet::carrier_track::inline questions {

/// The problem judged by what it shows now, so that it can be shown in another way.
inline Problem judged_as_it_is(Problem problem) {
  problem.truth = [evaluate = problem.evaluate](const Vector& x) { return truth_of(evaluate(x)); };
  return problem;
}

/// Shows this objective; with its exact derivatives if `derivatives`.
template <class Function>
void define(Problem& problem, const Function& objective, bool derivatives) {
  problem.evaluate = [objective](const Vector& x) { return Values{value_of(objective, x), {}}; };
  if (!derivatives) return;
  const Vector widths = problem.upper - problem.lower;
  problem.differentiate = [objective, widths](const Vector& x) {
    Gradient g = gradient_of<Function::jet_size>(objective, x, widths);
    return Derivatives{{g.value, {}}, std::move(g.gradient), Matrix(0, x.size()), g.trust};
  };
}

/// Shows this objective, which is not simulated, and this constraint, which is: it must be <=
/// level.
template <class Objective, class Constraint>
void define(Problem& problem, const Objective& objective, const Constraint& constraint,
            double level, bool derivatives) {
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
}

}  // namespace ricochet::carrier_track::inline questions
