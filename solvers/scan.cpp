#include "solvers/scan.h"

#include "solvers/unit_box.h"

namespace ricochet {

double van_der_corput(std::uint64_t k) {
  double result = 0;
  for (double digit = 0.5; k > 0; k >>= 1, digit /= 2) {
    if (k & 1U) result += digit;
  }
  return result;
}

Solver scan() {
  Solver solver;
  solver.name = "scan";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.accepts = [](const Problem& problem) {
    return problem.dimension() == 1 && problem.equalities == 0 && has_room(problem);
  };
  solver.solve = [](Evaluator& evaluator, const Vector&, Random&) -> SolverExit {
    const Problem& problem = evaluator.problem();
    const Vector width = problem.upper - problem.lower;
    evaluator.values(problem.lower);
    Vector x = problem.upper;
    for (std::uint64_t k = 1; evaluator.values(x); ++k) {
      x = problem.lower + van_der_corput(k) * width;
    }
    return {stopped_by_evaluator};
  };
  return solver;
}

}  // namespace ricochet
