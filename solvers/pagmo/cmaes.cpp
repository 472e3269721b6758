#include <algorithm>
#include <cmath>
#include <pagmo/algorithms/cmaes.hpp>

#include "solvers/pagmo/pagmo.h"
#include "solvers/pagmo/unit_problem.h"

namespace ricochet {
namespace {

constexpr double own_step = 0.5;     // of the box: pagmo's own default
constexpr double tuned_step = 0.25;  // of the box
constexpr int usual_growth = 2;      // of the population at every restart

/// One run, until it converges.
void run_cmaes(UnitBox& box, const Vector& start, Eigen::Index size, double initial_step,
               Random& random) {
  const pagmo::population population = population_of(box, start, size, random);
  constexpr double automatic = -1;
  pagmo::cmaes(endless, automatic, automatic, automatic, automatic, initial_step,
               pagmo_value_tolerance, pagmo_step_tolerance, false, true, seed_from(random))
      .evolve(population);
}

SolverTermination minimise(const GivenOptions& given, double usual_step, Evaluator& evaluator,
                           const Vector& start, Random& random) {
  UnitBox box(evaluator);
  run_cmaes(box, start, size_of(given, evolution_size(start.size())),
            number_of(given, "initial_step", usual_step), random);
  return {converged};
}

SolverTermination minimise_with_restarts(const GivenOptions& given, Evaluator& evaluator,
                                         const Vector& start, Random& random) {
  UnitBox box(evaluator);
  Vector from = start;
  const double step = number_of(given, "initial_step", tuned_step);
  const int growth = whole_of(given, "growth", usual_growth);
  for (Eigen::Index size = size_of(given, evolution_size(start.size()));; size *= growth) {
    run_cmaes(box, from, size, step, random);
    from = uniform_point(evaluator.lower(), evaluator.upper(), random);
  }
}

Solver cmaes(const std::string& name, double usual_step, const GivenOptions& given) {
  return pagmo_solver(name, pagmo_bounds_only,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise(given, usual_step, evaluator, start, random);
                      });
}

Solver cmaes_ipop(const GivenOptions& given) {
  return pagmo_solver("cmaes-ipop", pagmo_bounds_only,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_with_restarts(given, evaluator, start, random);
                      });
}

SolverOption step_option(double usual) {
  SolverOption option = real_option("initial_step", 0, 1, usual);
  option.without_least = true;
  return option;
}

}  // namespace

Solver pagmo_cmaes(Settings settings) {
  return settings == Settings::tuned ? cmaes("cmaes-tuned", tuned_step, {})
                                     : cmaes("cmaes", own_step, {});
}

Solver pagmo_cmaes_ipop() {
  return cmaes_ipop({});
}

std::vector<AdjustableSolver> adjustable_pagmo_cmaes() {
  const SolverOption population = population_option(5, evolution_size_in_words);
  SolverOption growth = whole_option("growth", 1, usual_growth);
  growth.most = 10;
  return {{"pagmo-cmaes",
           {step_option(own_step), population},
           [](const GivenOptions& given) { return cmaes("cmaes", own_step, given); }},
          {"pagmo-cmaes-tuned",
           {step_option(tuned_step), population},
           [](const GivenOptions& given) { return cmaes("cmaes-tuned", tuned_step, given); }},
          {"pagmo-cmaes-ipop", {step_option(tuned_step), population, growth}, cmaes_ipop}};
}

}  // namespace ricochet
