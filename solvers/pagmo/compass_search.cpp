#include <pagmo/algorithms/compass_search.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

constexpr double first_step = 0.25;  // of the box
constexpr double shrinkage = 0.5;

SolverTermination minimise(const GivenOptions& given, Evaluator& evaluator, const Vector& start,
                           Random& random) {
  UnitBox box(evaluator);
  pagmo::compass_search(endless, number_of(given, "initial_step", first_step), pagmo_step_tolerance,
                        number_of(given, "shrinkage", shrinkage))
      .evolve(population_of(box, start, 1, random));
  return {converged};
}

Solver compass_search(const GivenOptions& given) {
  Solver solver = pagmo_solver("compass-search", pagmo_all_constraints,
                               [=](Evaluator& evaluator, const Vector& start, Random& random) {
                                 return minimise(given, evaluator, start, random);
                               });
  solver.stochastic = false;
  return solver;
}

}  // namespace

Solver pagmo_compass_search() {
  return compass_search({});
}

AdjustableSolver adjustable_pagmo_compass_search() {
  return {"pagmo-compass-search",
          {real_option("initial_step", 1e-6, 1, first_step),
           real_option("shrinkage", 0.01, 0.99, shrinkage)},
          compass_search};
}

}  // namespace ricochet
