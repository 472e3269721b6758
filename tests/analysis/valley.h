#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "tests/core/best_point_of.h"

namespace ricochet::comparison {

/// |x - 0.5| on [0, 1]; at a smoothing parameter its best point is moved up by the smoothing
/// parameter, and it has derivatives.
inline Problem valley(double smoothing) {
  Problem problem;
  problem.name = "valley";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Ones(1);
  problem.start = Vector::Zero(1);
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(1, 0.5);
  problem.evaluate = [smoothing](const Vector& x) {
    return Values{std::abs(x[0] - 0.5 - smoothing), {}};
  };
  problem.true_values = [](const Vector& x) { return TrueValues{std::abs(x[0] - 0.5), 0}; };
  if (smoothing > 0) {
    problem.differentiate = [evaluate = problem.evaluate, smoothing](const Vector& x) {
      return Derivatives{evaluate(x), Vector::Constant(1, x[0] > 0.5 + smoothing ? 1 : -1),
                         Matrix(0, 1)};
    };
  }
  problem.smoothed = valley;
  return problem;
}

inline Problem valley_problem() {
  Problem problem = valley(0);
  problem.smoothing = 0.25;
  problem.tolerance = 1e-9;
  problem.scan_step = 1e-3;
  return problem;
}

/// Asks for `wasted` points at the lower end, then for the best point, and returns the end; or the
/// best point, if it got that far and `returns_best`.
inline Solver patient(std::string name, int wasted, bool needs_derivatives = false,
                      bool returns_best = false) {
  Solver solver;
  solver.name = std::move(name);
  if (needs_derivatives) solver.capabilities.derivatives = Capabilities::Order::gradient;
  solver.solve = [=](Evaluator& evaluator, const Vector&, Random&) {
    for (int i = 0; i < wasted; ++i) evaluator.objective(evaluator.lower());
    Problem known = valley(0);
    known.name = evaluator.name();
    const Vector best = best_point_of(known, evaluator);
    const bool evaluated = evaluator.objective(best).has_value();
    return SolverTermination{"done", evaluated && returns_best ? best : evaluator.lower()};
  };
  return solver;
}

}  // namespace ricochet::comparison
