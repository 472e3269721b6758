#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/compass_search.hpp>
#include <pagmo/algorithms/cstrs_self_adaptive.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "ricochet/random.h"
#include "ricochet/solver.h"
#include "tests/solvers/direct_calls.h"

namespace ricochet {
namespace {

std::vector<double> listed(const Vector& x) {
  return {x.begin(), x.end()};
}

struct ForPagmo {
  const DirectCall* call = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& u) const {
    const Values seen = *call->evaluator.values(call->at(u.data()));
    pagmo::vector_double told = {seen.objective};
    told.insert(told.end(), seen.constraints.begin(), seen.constraints.end());
    return told;
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {listed(call->problem.lower), listed(call->problem.upper)};
  }
  pagmo::vector_double::size_type get_nec() const {
    return static_cast<std::size_t>(call->problem.equalities);
  }
  pagmo::vector_double::size_type get_nic() const {
    return static_cast<std::size_t>(call->problem.constraints) - get_nec();
  }
};

}  // namespace

Vector call_pagmo(const std::string& solver, const DirectCall& call) {
  const auto n = static_cast<double>(call.problem.dimension());
  const bool strategy = solver.starts_with("pagmo-cmaes") || solver == "pagmo-xnes";
  auto size = static_cast<std::size_t>(strategy ? std::max(5.0, 4 + std::floor(3 * std::log(n)))
                                                : std::clamp(10 * n, 20.0, 100.0));
  if (solver == "pagmo-compass-search") size = 1;
  const auto seed = static_cast<unsigned>(call.seed);
  const double f = std::numeric_limits<double>::min();
  const double x = 1e-8 * call.width().maxCoeff();
  const auto generations = static_cast<unsigned>(call.limit) / static_cast<unsigned>(size) + 1;
  Vector start = call.problem.start;
  // From the start and points that pagmo draws.
  const auto best = [&](const auto& algorithm) {
    pagmo::problem shown{ForPagmo{&call}};
    shown.set_c_tol(pagmo::vector_double(shown.get_nc(), constraint_tolerance));
    pagmo::population population(shown, 0, seed);
    population.push_back(listed(start));
    while (population.size() < size) population.push_back(population.random_decision_vector());
    population = algorithm.evolve(population);
    return call.at(population.get_x()[population.best_idx()].data());
  };
  if (solver.starts_with("pagmo-cmaes")) {
    const double step = solver.ends_with("-tuned") ? 0.25 : 0.5;
    const pagmo::cmaes cmaes(generations, -1, -1, -1, -1, step, f, x, false, true, seed);
    const bool is_restarted = solver.starts_with("pagmo-cmaes-ipop");
    Random random(call.seed);
    for (;; size *= 2) {
      const Vector found = best(cmaes);
      if (!is_restarted || call.evaluator.ledger().charged >= call.limit) return found;
      start = uniform_point(call.problem.lower, call.problem.upper, random);
    }
  }
  if (solver == "pagmo-xnes") {
    return best(pagmo::xnes(generations, -1, -1, -1, -1, f, x, false, true, seed));
  }
  if (solver == "pagmo-de") return best(pagmo::de(generations, 0.8, 0.9, 2, f, x, seed));
  if (solver == "pagmo-sade") return best(pagmo::sade(generations, 2, 1, f, x, false, seed));
  if (solver == "pagmo-de1220") {
    const auto variants = pagmo::de1220_statics<void>::allowed_variants;
    return best(pagmo::de1220(generations, variants, 1, f, x, false, seed));
  }
  if (solver == "pagmo-gaco") {
    return best(pagmo::gaco(generations, static_cast<unsigned>(size), 1.0, 0.0, 0.01, 1, 7, 100000,
                            100000, 0.0, false, seed));
  }
  if (solver == "pagmo-compass-search") {
    return best(pagmo::compass_search(generations, 0.1, 1e-8, 0.5));
  }
  const pagmo::de inner(1, 0.8, 0.9, 2, 0.0, 0.0, seed);
  return best(pagmo::cstrs_self_adaptive(generations, inner, seed));
}

}  // namespace ricochet
