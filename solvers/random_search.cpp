#include "solvers/random_search.h"

#include "solvers/unit_box.h"
#include "src/core/instance.h"

namespace ricochet {

Solver random_search() {
  Solver solver;
  solver.name = "random-search";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.equalities == 0;
  };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) -> SolverExit {
    Vector x = start;
    while (evaluator.values(x)) x = uniform_point(evaluator.problem(), random);
    return {stopped_by_evaluator};
  };
  return solver;
}

}  // namespace ricochet
