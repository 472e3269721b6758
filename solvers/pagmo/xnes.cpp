#include <pagmo/algorithms/xnes.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

SolverExit minimise(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  const pagmo::population population =
      population_of(box, evaluator.problem(), start, evolution_size(start.size()), random);
  constexpr double automatic = -1;
  pagmo::xnes(endless, automatic, automatic, automatic, automatic, pagmo_value_tolerance,
              pagmo_step_tolerance, false, true, seed_from(random))
      .evolve(population);
  return {converged};
}

}  // namespace

Solver pagmo_xnes() {
  return pagmo_solver("xnes", Takes::unconstrained, minimise);
}

}  // namespace ricochet
