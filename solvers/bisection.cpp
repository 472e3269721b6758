#include "solvers/bisection.h"

#include <cmath>

#include "solvers/unit_box.h"

namespace ricochet {

Solver bisection() {
  constexpr double step_tolerance = 1e-8;  // of the box
  Solver solver;
  solver.name = "bisection";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.capabilities = {.most_variables = 1,
                         .constraints = Capabilities::Constraints::inequalities,
                         .needs_constraints = true};
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    const Vector &lower = evaluator.lower(), &upper = evaluator.upper();
    const auto at_lower = evaluator.values(lower);
    const auto at_upper = evaluator.values(upper);
    if (!at_upper) return {stopped_by_evaluator};
    const bool upwards = at_upper->objective < at_lower->objective;
    if (true_values_of(upwards ? *at_upper : *at_lower).violation <= 0)
      return {"the end is feasible"};
    Vector feasible = upwards ? lower : upper;  // assumed
    Vector infeasible = upwards ? upper : lower;
    const double width = upper[0] - lower[0];
    for (Vector x = start; std::abs(feasible[0] - infeasible[0]) > step_tolerance * width;
         x = (feasible + infeasible) / 2) {
      const auto values = evaluator.values(x);
      if (!values) return {stopped_by_evaluator};
      (true_values_of(*values).violation <= 0 ? feasible : infeasible) = x;
    }
    return {"the interval is short", feasible};
  };
  return solver;
}

}  // namespace ricochet
