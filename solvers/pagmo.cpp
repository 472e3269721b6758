#include "solvers/pagmo.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/config.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

#include "solvers/unit_box.h"
#include "src/core/instance.h"

namespace ricochet {
namespace {

/// What a point without a number counts as, and one that the evaluator refuses.
constexpr double worst = std::numeric_limits<double>::max();

/// Generations between two looks at the evaluator. Those after its refusal cost next to nothing.
constexpr unsigned batch = 10;

constexpr double step_tolerance = 1e-8;                                 // of the box
constexpr double value_tolerance = std::numeric_limits<double>::min();  // none but 0 is below

/// The objective over the unit cube, as pagmo wants to be told. pagmo copies it.
class UnitObjective {
 public:
  explicit UnitObjective(UnitBox* box = nullptr, Eigen::Index dimension = 1)
      : box_(box), dimension_(static_cast<std::size_t>(dimension)) {}

  pagmo::vector_double fitness(const pagmo::vector_double& u) const {
    const auto values = box_->values(Eigen::Map<const Vector>(u.data(), std::ssize(u)));
    return {values && std::isfinite(values->objective) ? values->objective : worst};
  }

  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(dimension_, 0.0), pagmo::vector_double(dimension_, 1.0)};
  }

 private:
  UnitBox* box_;
  std::size_t dimension_;
};

/// pagmo's seeds have 32 bits.
unsigned seed_from(Random& random) {
  return static_cast<unsigned>(random());
}

/// The start, and points uniform in the box.
pagmo::population population_of(UnitBox& box, const Problem& problem, const Vector& start,
                                Eigen::Index size, Random& random) {
  pagmo::population population(UnitObjective(&box, problem.dimension()), 0, seed_from(random));
  Vector x = start;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Vector u = box.to_unit(x).cwiseMax(0.0).cwiseMin(1.0);
    population.push_back(pagmo::vector_double(u.begin(), u.end()));
    x = uniform_point(problem, random);
  }
  return population;
}

/// `algorithm` makes `batch` generations at a time and remembers what it has learnt.
template <class Algorithm>
SolverExit evolve(const Algorithm& algorithm, pagmo::population population,
                  const Evaluator& evaluator) {
  const auto asked = [&population] { return population.get_problem().get_fevals(); };
  while (!evaluator.over()) {
    const auto before = asked();
    population = algorithm.evolve(std::move(population));
    // Where it ends at the last generation of a batch, it does so again at the first of the next.
    if (!evaluator.over() && asked() - before < batch * population.size()) return {"converged"};
  }
  return {stopped_by_evaluator};
}

Eigen::Index cmaes_size(Eigen::Index n) {
  return std::max<Eigen::Index>(5, 4 + static_cast<Eigen::Index>(3 * std::log(n)));
}

Eigen::Index sade_size(Eigen::Index n) {
  return std::clamp<Eigen::Index>(10 * n, 20, 100);
}

SolverExit minimise_by_cmaes(Evaluator& evaluator, const Vector& start, Random& random,
                             double initial_step) {
  UnitBox box(evaluator);
  auto population =
      population_of(box, evaluator.problem(), start, cmaes_size(start.size()), random);
  constexpr double automatic = -1;
  const pagmo::cmaes algorithm(batch, automatic, automatic, automatic, automatic, initial_step,
                               value_tolerance, step_tolerance, true, true, seed_from(random));
  return evolve(algorithm, std::move(population), evaluator);
}

SolverExit minimise_by_sade(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  auto population = population_of(box, evaluator.problem(), start, sade_size(start.size()), random);
  constexpr unsigned rand_1_exp = 2;  // pagmo's own default
  constexpr unsigned jde = 1;
  const pagmo::sade algorithm(batch, rand_1_exp, jde, value_tolerance, step_tolerance, true,
                              seed_from(random));
  return evolve(algorithm, std::move(population), evaluator);
}

template <class Minimise>
Solver adapter(const char* name, Minimise minimise) {
  Solver solver;
  solver.name = name;
  solver.version = "pagmo " PAGMO_VERSION;
  solver.stochastic = true;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.constraints == 0;
  };
  solver.solve = minimise;
  return solver;
}

}  // namespace

Solver pagmo_cmaes(Settings settings) {
  const bool tuned = settings == Settings::tuned;
  const double initial_step = tuned ? 0.25 : 0.5;  // of the box; pagmo's own default is 0.5
  return adapter(tuned ? "pagmo-cmaes-tuned" : "pagmo-cmaes",
                 [initial_step](Evaluator& evaluator, const Vector& start, Random& random) {
                   return minimise_by_cmaes(evaluator, start, random, initial_step);
                 });
}

Solver pagmo_sade() {
  return adapter("pagmo-sade", minimise_by_sade);
}

}  // namespace ricochet
