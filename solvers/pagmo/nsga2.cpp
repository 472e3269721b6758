#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/utils/hypervolume.hpp>
#include <utility>

#include "ricochet/random.h"
#include "solvers/several_goals.h"

namespace ricochet {
namespace {

constexpr double nsga2_crossover = 0.95;  // probability
constexpr double crossover_index = 10;    // closeness to the parents: pagmo's own
constexpr double mutation_index = 20;     // Deb's

/// The goals with pagmo's interface; pagmo copies this. Every point evaluated goes into the front.
struct ToldGoals {
  const SeveralGoals* problem = nullptr;
  Front* front = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& u) const {
    Vector at = Eigen::Map<const Vector>(u.data(), static_cast<Eigen::Index>(u.size()));
    Vector goals = problem->evaluate(at);
    pagmo::vector_double told(goals.begin(), goals.end());
    add(*front, {std::move(at), std::move(goals)});
    return told;
  }

  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t n = problem == nullptr ? 1 : static_cast<std::size_t>(problem->variables);
    return {pagmo::vector_double(n, 0.0), pagmo::vector_double(n, 1.0)};
  }

  pagmo::vector_double::size_type get_nobj() const {
    return problem == nullptr ? 2 : static_cast<std::size_t>(problem->goals);
  }
};

pagmo::vector_double uniform_in_cube(Eigen::Index n, Random& random) {
  pagmo::vector_double u;
  for (Eigen::Index i = 0; i < n; ++i) u.push_back(uniform(random));
  return u;
}

}  // namespace

Front nsga2_front(const SeveralGoals& problem, const FrontSearch& search) {
  Front front;
  Random random(search.seed);
  pagmo::population population(pagmo::problem(ToldGoals{&problem, &front}), 0,
                               static_cast<unsigned>(random()));
  for (const Vector& start : search.starts) {
    population.push_back(pagmo::vector_double(start.begin(), start.end()));
  }
  while (population.size() < static_cast<std::size_t>(search.population)) {
    population.push_back(uniform_in_cube(problem.variables, random));
  }
  const double mutation = 1.0 / static_cast<double>(problem.variables);
  pagmo::nsga2(static_cast<unsigned>(search.generations), nsga2_crossover, crossover_index,
               mutation, mutation_index, static_cast<unsigned>(random()))
      .evolve(population);
  return front;
}

double hypervolume(const Front& front, const Vector& reference) {
  std::vector<pagmo::vector_double> points;
  for (const FrontPoint& point : front) {
    if ((point.goals.array() < reference.array()).all()) {
      points.emplace_back(point.goals.begin(), point.goals.end());
    }
  }
  if (points.empty()) return 0;
  return pagmo::hypervolume(points).compute(
      pagmo::vector_double(reference.begin(), reference.end()));
}

}  // namespace ricochet
