#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/sade.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

constexpr double weight = 0.8, crossover = 0.9;  // pagmo's own defaults
constexpr unsigned rand_1_exp = 2;
constexpr unsigned jde = 1;

pagmo::de plain(unsigned seed) {
  return pagmo::de(endless, weight, crossover, rand_1_exp, pagmo_value_tolerance,
                   pagmo_step_tolerance, seed);
}

pagmo::sade adapting(unsigned seed) {
  return pagmo::sade(endless, rand_1_exp, jde, pagmo_value_tolerance, pagmo_step_tolerance, false,
                     seed);
}

pagmo::de1220 choosing(unsigned seed) {
  return pagmo::de1220(endless, pagmo::de1220_statics<void>::allowed_variants, jde,
                       pagmo_value_tolerance, pagmo_step_tolerance, false, seed);
}

template <auto algorithm>
SolverExit minimise(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  const pagmo::population population =
      population_of(box, evaluator.problem(), start, usual_size(start.size()), random);
  algorithm(seed_from(random)).evolve(population);
  return {converged};
}

}  // namespace

Solver pagmo_de() {
  return pagmo_solver("de", Takes::unconstrained, minimise<plain>);
}

Solver pagmo_sade() {
  return pagmo_solver("sade", Takes::unconstrained, minimise<adapting>);
}

Solver pagmo_de1220() {
  return pagmo_solver("de1220", Takes::unconstrained, minimise<choosing>);
}

}  // namespace ricochet
