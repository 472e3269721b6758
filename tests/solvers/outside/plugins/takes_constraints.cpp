#include <ricochet/ricochet.h>

/// Goes from the problem's start to where its first constraint is 0, by Newton's method along the
/// gradient of that constraint.
const ricochet_solver ricochet_plugin = {
    RICOCHET_ABI,
    "to-the-first-constraint",
    "1",
    1,
    1,
    0,
    0,
    [](ricochet_problem* problem, double* point) -> const char* {
      double objective = 0, constraint = 1, gradient[2], jacobian[2];
      for (int i = 0; i < 2; ++i) point[i] = problem->start[i];
      for (int step = 0; step < 50; ++step) {
        if (problem->derivatives(problem, point, &objective, &constraint, gradient, jacobian) !=
            0) {
          return "over";
        }
        const double square = jacobian[0] * jacobian[0] + jacobian[1] * jacobian[1];
        for (int i = 0; i < 2; ++i) point[i] -= (constraint + 1e-9) * jacobian[i] / square;
      }
      return "fifty steps";
    }};
