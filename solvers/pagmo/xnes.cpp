#include <pagmo/algorithms/xnes.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

constexpr double automatic = -1;

SolverTermination minimise_by_xnes(const GivenOptions& given, Evaluator& evaluator,
                                   const Vector& start, Random& random) {
  UnitBox box(evaluator);
  const pagmo::population population =
      population_of(box, start, size_of(given, evolution_size(start.size())), random);
  pagmo::xnes(endless, automatic, automatic, automatic, number_of(given, "initial_step", automatic),
              pagmo_value_tolerance, pagmo_step_tolerance, false, true, seed_from(random))
      .evolve(population);
  return {converged};
}

Solver xnes(const GivenOptions& given) {
  return pagmo_solver("xnes", pagmo_bounds_only,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_by_xnes(given, evaluator, start, random);
                      });
}

}  // namespace

Solver pagmo_xnes() {
  return xnes({});
}

AdjustableSolver adjustable_pagmo_xnes() {
  SolverOption step = real_option("initial_step", 0, 1, 0);
  step.without_least = true;
  step.usual = "pagmo's";
  return {"pagmo-xnes", {step, population_option(4, evolution_size_in_words)}, xnes};
}

}  // namespace ricochet
