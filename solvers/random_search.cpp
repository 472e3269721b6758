#include "solvers/random_search.h"

#include "solvers/unit_box.h"

namespace ricochet {

Solver random_search() {
  Solver solver;
  solver.name = "random-search";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.capabilities.constraints = Capabilities::Constraints::inequalities;
  solver.solve = [](Evaluator& evaluator, const Vector& start,
                    Random& random) -> SolverTermination {
    Vector x = start;
    while (evaluator.values(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return {stopped_by_evaluator};
  };
  return solver;
}

}  // namespace ricochet
