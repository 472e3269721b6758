#include <cmath>
#include <pagmo/algorithms/cstrs_self_adaptive.hpp>
#include <pagmo/algorithms/de.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

/// The distance from the best point to the worst, summed over the axes.
double spread(const pagmo::population& population) {
  const pagmo::vector_double best = population.get_x()[population.best_idx()];
  const pagmo::vector_double worst = population.get_x()[population.worst_idx()];
  double sum = 0;
  for (std::size_t i = 0; i < best.size(); ++i) sum += std::abs(best[i] - worst[i]);
  return sum;
}

constexpr double weight = 0.8, crossover = 0.9;  // pagmo's own defaults, as is the rest

SolverTermination minimise_constrained(const GivenOptions& given, Evaluator& evaluator,
                                       const Vector& start, Random& random) {
  UnitBox box(evaluator);
  pagmo::population population =
      population_of(box, start, size_of(given, usual_size(start.size())), random);
  constexpr unsigned rand_1_exp = 2;
  const pagmo::de generation(1, number_of(given, "weight", weight),
                             number_of(given, "crossover", crossover), rand_1_exp, 0.0, 0.0,
                             seed_from(random));
  const pagmo::cstrs_self_adaptive algorithm(1, generation, seed_from(random));
  // pagmo remembers the points of a generation and evaluates none if they are all equal.
  unsigned long long asked = 0;
  while (population.get_problem().get_fevals() > asked &&
         spread(population) >= pagmo_step_tolerance) {
    asked = population.get_problem().get_fevals();
    population = algorithm.evolve(population);
  }
  return {converged};
}

Solver constrained_de(const GivenOptions& given) {
  return pagmo_solver("constrained-de", pagmo_needs_constraints,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_constrained(given, evaluator, start, random);
                      });
}

}  // namespace

Solver pagmo_constrained_de() {
  return constrained_de({});
}

AdjustableSolver adjustable_pagmo_constrained_de() {
  return {"pagmo-constrained-de",
          {real_option("weight", 0, 1, weight), real_option("crossover", 0, 1, crossover),
           population_option(5, usual_size_in_words)},
          constrained_de};
}

}  // namespace ricochet
