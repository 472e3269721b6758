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
  solver.capabilities = {.most_variables = 1,
                         .constraints = Capabilities::Constraints::inequalities};
  solver.solve = [](Evaluator& evaluator, const Vector&, Random&) -> SolverTermination {
    const Vector width = evaluator.upper() - evaluator.lower();
    evaluator.values(evaluator.lower());
    Vector x = evaluator.upper();
    for (std::uint64_t k = 1; evaluator.values(x); ++k) {
      x = evaluator.lower() + van_der_corput(k) * width;
    }
    return {stopped_by_evaluator};
  };
  return solver;
}

}  // namespace ricochet
