#include <algorithm>
#include <limits>
#include <pagmo/algorithms/gaco.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

/// The highest objective of the population, without points that are not finite. With this value as
/// pagmo's oracle, feasible points come first.
double highest(const pagmo::population& population) {
  double highest = std::numeric_limits<double>::lowest();
  for (const pagmo::vector_double& values : population.get_f()) {
    if (values[0] < without_a_number) highest = std::max(highest, values[0]);
  }
  return highest;
}

SolverTermination minimise_by_gaco(const GivenOptions& given, Evaluator& evaluator,
                                   const Vector& start, Random& random) {
  UnitBox box(evaluator);
  const Eigen::Index size = size_of(given, usual_size(start.size()));
  const pagmo::population population = population_of(box, start, size, random);
  constexpr double spread = 1;    // pagmo's own default
  constexpr double accuracy = 0;  // two values differ if they are not equal
  constexpr unsigned threshold = 1, marks = 7, never = 0;  // pagmo's own defaults
  const int kernel =
      std::min(whole_of(given, "kernel", static_cast<int>(size)), static_cast<int>(size));
  pagmo::gaco(endless, static_cast<unsigned>(kernel), spread, highest(population), accuracy,
              threshold, marks, never, never, 0.0, false, seed_from(random))
      .evolve(population);
  return {converged};
}

Solver gaco(const GivenOptions& given) {
  return pagmo_solver("gaco", pagmo_all_constraints,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_by_gaco(given, evaluator, start, random);
                      });
}

}  // namespace

Solver pagmo_gaco() {
  return gaco({});
}

AdjustableSolver adjustable_pagmo_gaco() {
  return {"pagmo-gaco",
          {population_option(10, usual_size_in_words),
           whole_option("kernel", 2, "the population; it is never more")},
          gaco};
}

}  // namespace ricochet
