#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "src/core/question.h"
#include "src/core/solver.h"

namespace ricochet::contest {

/// |x - 0.5| on [0, 1]; at a smoothing width its best point is moved up by the width, and it has
/// derivatives.
inline Problem valley(double width) {
  Problem problem;
  problem.name = "valley";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Ones(1);
  problem.start = Vector::Zero(1);
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(1, 0.5);
  problem.evaluate = [width](const Vector& x) { return Values{std::abs(x[0] - 0.5 - width), {}}; };
  problem.truth = [](const Vector& x) { return Truth{std::abs(x[0] - 0.5), 0}; };
  if (width > 0) {
    problem.differentiate = [evaluate = problem.evaluate, width](const Vector& x) {
      return Derivatives{evaluate(x), Vector::Constant(1, x[0] > 0.5 + width ? 1 : -1),
                         Matrix(0, 1)};
    };
  }
  problem.smoothed = valley;
  return problem;
}

inline Question valley_question() {
  return {.stated = valley(0), .width = 0.25, .tolerance = 1e-9, .scan_step = 1e-3};
}

/// Asks for `wasted` points at the lower end, then for the best point, and hands over the end.
inline Solver patient(std::string name, int wasted, bool needs_derivatives = false) {
  Solver solver;
  solver.name = std::move(name);
  solver.accepts = [needs_derivatives](const Problem& problem) {
    return !needs_derivatives || problem.differentiate;
  };
  solver.solve = [wasted](Evaluator& evaluator, const Vector&, Random&) {
    const Problem& problem = evaluator.problem();
    for (int i = 0; i < wasted; ++i) evaluator.objective(problem.lower);
    evaluator.objective(*problem.best_point);
    return SolverExit{"done", problem.lower};
  };
  return solver;
}

}  // namespace ricochet::contest
