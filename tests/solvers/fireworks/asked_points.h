#pragma once

#include <vector>

#include "ricochet/run.h"

namespace ricochet {

/// Every point that a run of the solver asks for, in order.
inline std::vector<Vector> asked_points(const Problem& problem, const Solver& solver,
                                        std::int64_t evaluations, int number = 1) {
  std::vector<Vector> asked;
  Problem recorded = problem;
  recorded.evaluate = [&](const Vector& x) {
    asked.push_back(x);
    return problem.evaluate(x);
  };
  run(recorded, solver, {evaluations}, number);
  return asked;
}

}  // namespace ricochet
