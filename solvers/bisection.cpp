#include "solvers/bisection.h"

#include <cmath>

#include "solvers/unit_box.h"

namespace ricochet {

Solver bisection() {
  constexpr double step_tolerance = 1e-8;  // of the box
  Solver solver;
  solver.name = "bisection";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.accepts = [](const Problem& problem) {
    return problem.dimension() == 1 && problem.constraints > 0 && problem.equalities == 0 &&
           has_room(problem);
  };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverExit {
    const Problem& problem = evaluator.problem();
    const auto at_lower = evaluator.values(problem.lower);
    const auto at_upper = evaluator.values(problem.upper);
    if (!at_upper) return {stopped_by_evaluator};
    const bool upwards = at_upper->objective < at_lower->objective;
    if (truth_of(upwards ? *at_upper : *at_lower).violation <= 0) return {"the end is feasible"};
    Vector feasible = upwards ? problem.lower : problem.upper;  // taken to be
    Vector infeasible = upwards ? problem.upper : problem.lower;
    const double width = problem.upper[0] - problem.lower[0];
    for (Vector x = start; std::abs(feasible[0] - infeasible[0]) > step_tolerance * width;
         x = (feasible + infeasible) / 2) {
      const auto values = evaluator.values(x);
      if (!values) return {stopped_by_evaluator};
      (truth_of(*values).violation <= 0 ? feasible : infeasible) = x;
    }
    return {"the interval is short", feasible};
  };
  return solver;
}

}  // namespace ricochet
