#include <algorithm>
#include <cmath>
#include <limits>
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
#include <string>
#include <utility>
#include <vector>

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
    if (call == nullptr) return {{0}, {1}};
    return {listed(call->u(call->problem.lower)), listed(call->u(call->problem.upper))};
  }
  pagmo::vector_double::size_type get_nec() const {
    return call ? static_cast<std::size_t>(call->problem.equalities) : 0;
  }
  pagmo::vector_double::size_type get_nic() const {
    return call ? static_cast<std::size_t>(call->problem.constraints) - get_nec() : 0;
  }
};

/// The start and points that pagmo draws.
pagmo::population population_of(const DirectCall& call, std::size_t size, const Vector& start,
                                unsigned seed) {
  pagmo::problem shown{ForPagmo{&call}};
  shown.set_c_tol(pagmo::vector_double(shown.get_nc(), constraint_tolerance));
  pagmo::population population(shown, 0, seed);
  population.push_back(listed(call.u(start)));
  while (population.size() < size) population.push_back(population.random_decision_vector());
  return population;
}

}  // namespace

Vector call_pagmo(const std::string& solver, const DirectCall& call) {
  const auto n = static_cast<double>(call.problem.dimension());
  const bool strategy = solver.starts_with("pagmo-cmaes") || solver == "pagmo-xnes";
  const bool compass = solver == "pagmo-compass-search";
  auto size = static_cast<std::size_t>(strategy ? std::max(5.0, 4 + std::floor(3 * std::log(n)))
                                                : std::clamp(10 * n, 20.0, 100.0));
  if (compass) size = 1;
  const auto seed = static_cast<unsigned>(call.seed);
  const double f = std::numeric_limits<double>::min();
  const double x = 1e-8 * call.width().cwiseQuotient(call.scale()).maxCoeff();
  const auto generations = static_cast<unsigned>(call.limit) / static_cast<unsigned>(size) + 1;
  const auto best = [&](const auto& algorithm, std::size_t members, const Vector& start) {
    const pagmo::population population =
        algorithm.evolve(population_of(call, members, start, seed));
    return call.at(population.get_x()[population.best_idx()].data());
  };
  const Vector& start = call.problem.start;
  const pagmo::cmaes cmaes(generations, -1, -1, -1, -1, solver.ends_with("-tuned") ? 0.25 : 0.5, f,
                           x, false, true, seed);
  if (solver == "pagmo-cmaes" || solver == "pagmo-cmaes-tuned") return best(cmaes, size, start);
  if (solver.starts_with("pagmo-cmaes-ipop")) {
    Random random(call.seed);
    Vector from = start;
    for (;; size *= 2) {
      const Vector found = best(cmaes, size, from);
      if (call.evaluator.ledger().charged >= call.limit) return found;
      from = uniform_point(call.problem.lower, call.problem.upper, random);
    }
  }
  if (solver == "pagmo-xnes") {
    return best(pagmo::xnes(generations, -1, -1, -1, -1, f, x, false, true, seed), size, start);
  }
  if (solver == "pagmo-de") {
    return best(pagmo::de(generations, 0.8, 0.9, 2, f, x, seed), size, start);
  }
  if (solver == "pagmo-sade") {
    return best(pagmo::sade(generations, 2, 1, f, x, false, seed), size, start);
  }
  if (solver == "pagmo-de1220") {
    const auto variants = pagmo::de1220_statics<void>::allowed_variants;
    return best(pagmo::de1220(generations, variants, 1, f, x, false, seed), size, start);
  }
  if (solver == "pagmo-gaco") {
    return best(pagmo::gaco(generations, static_cast<unsigned>(size), 1.0, 0.0, 0.01, 1, 7, 100000,
                            100000, 0.0, false, seed),
                size, start);
  }
  if (compass) {
    const double step = call.library_chooses ? 0.1 : 0.25;
    return best(pagmo::compass_search(generations, step, 1e-8, 0.5), size, start);
  }
  const pagmo::de inner(1, 0.8, 0.9, 2, 0.0, 0.0, seed);
  return best(pagmo::cstrs_self_adaptive(generations, inner, seed), size, start);
}

}  // namespace ricochet
