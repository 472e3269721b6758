#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/sade.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

constexpr double de_weight = 0.8, de_crossover = 0.9;  // pagmo's own defaults
constexpr unsigned rand_1_exp = 2;
constexpr unsigned jde = 1;

unsigned variant_of(const GivenOptions& given) {
  return static_cast<unsigned>(whole_of(given, "variant", rand_1_exp));
}

unsigned adaptation_of(const GivenOptions& given) {
  return static_cast<unsigned>(whole_of(given, "adaptation", jde));
}

pagmo::de plain(const GivenOptions& given, unsigned seed) {
  return pagmo::de(endless, number_of(given, "weight", de_weight),
                   number_of(given, "crossover", de_crossover), variant_of(given),
                   pagmo_value_tolerance, pagmo_step_tolerance, seed);
}

pagmo::sade adapting(const GivenOptions& given, unsigned seed) {
  return pagmo::sade(endless, variant_of(given), adaptation_of(given), pagmo_value_tolerance,
                     pagmo_step_tolerance, false, seed);
}

pagmo::de1220 choosing(const GivenOptions& given, unsigned seed) {
  return pagmo::de1220(endless, pagmo::de1220_statics<void>::allowed_variants, adaptation_of(given),
                       pagmo_value_tolerance, pagmo_step_tolerance, false, seed);
}

template <auto algorithm>
Solver made(const std::string& name, const GivenOptions& given) {
  return pagmo_solver(
      name, pagmo_bounds_only,
      [given](Evaluator& evaluator, const Vector& start, Random& random) -> SolverTermination {
        UnitBox box(evaluator);
        const pagmo::population population =
            population_of(box, start, size_of(given, usual_size(start.size())), random);
        algorithm(given, seed_from(random)).evolve(population);
        return {converged};
      });
}

/// An option with pagmo's numbers, from 1 on.
SolverOption kind_option(const std::string& name, int most, unsigned usual) {
  SolverOption option = whole_option(name, 1, static_cast<int>(usual));
  option.most = most;
  return option;
}

}  // namespace

Solver pagmo_de() {
  return made<plain>("de", {});
}

Solver pagmo_sade() {
  return made<adapting>("sade", {});
}

Solver pagmo_de1220() {
  return made<choosing>("de1220", {});
}

std::vector<AdjustableSolver> adjustable_pagmo_de() {
  const SolverOption adaptation = kind_option("adaptation", 2, jde);
  const SolverOption population = population_option(7, usual_size_in_words);
  return {{"pagmo-de",
           {real_option("weight", 0, 1, de_weight), real_option("crossover", 0, 1, de_crossover),
            kind_option("variant", 10, rand_1_exp), population_option(5, usual_size_in_words)},
           [](const GivenOptions& given) { return made<plain>("de", given); }},
          {"pagmo-sade",
           {kind_option("variant", 18, rand_1_exp), adaptation, population},
           [](const GivenOptions& given) { return made<adapting>("sade", given); }},
          {"pagmo-de1220", {adaptation, population}, [](const GivenOptions& given) {
             return made<choosing>("de1220", given);
           }}};
}

}  // namespace ricochet
