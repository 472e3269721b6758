#include <algorithm>
#include <cmath>
#include <pagmo/algorithms/cmaes.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"
#include "src/core/instance.h"

namespace ricochet {
namespace {

constexpr double own_step = 0.5;     // of the box: pagmo's own default
constexpr double tuned_step = 0.25;  // of the box

/// One run, until it converges.
void run_cmaes(UnitBox& box, const Problem& problem, const Vector& start, Eigen::Index size,
               double initial_step, Random& random) {
  const pagmo::population population = population_of(box, problem, start, size, random);
  constexpr double automatic = -1;
  pagmo::cmaes(endless, automatic, automatic, automatic, automatic, initial_step,
               pagmo_value_tolerance, pagmo_step_tolerance, false, true, seed_from(random))
      .evolve(population);
}

template <bool tuned>
SolverExit minimise(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  run_cmaes(box, evaluator.problem(), start, evolution_size(start.size()),
            tuned ? tuned_step : own_step, random);
  return {converged};
}

SolverExit minimise_with_restarts(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  Vector from = start;
  for (Eigen::Index size = evolution_size(start.size());; size *= 2) {
    run_cmaes(box, evaluator.problem(), from, size, tuned_step, random);
    from = uniform_point(evaluator.problem(), random);
  }
}

}  // namespace

Solver pagmo_cmaes(Settings settings) {
  return settings == Settings::tuned
             ? pagmo_solver("cmaes-tuned", Takes::unconstrained, minimise<true>)
             : pagmo_solver("cmaes", Takes::unconstrained, minimise<false>);
}

Solver pagmo_cmaes_ipop() {
  return pagmo_solver("cmaes-ipop", Takes::unconstrained, minimise_with_restarts);
}

}  // namespace ricochet
