#include <pagmo/algorithms/compass_search.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

SolverExit minimise(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  constexpr double first_step = 0.25;  // of the box
  constexpr double shrinkage = 0.5;
  pagmo::compass_search(endless, first_step, pagmo_step_tolerance, shrinkage)
      .evolve(population_of(box, evaluator.problem(), start, 1, random));
  return {converged};
}

}  // namespace

Solver pagmo_compass_search() {
  Solver solver = pagmo_solver("compass-search", Takes::both, minimise);
  solver.stochastic = false;
  return solver;
}

}  // namespace ricochet
