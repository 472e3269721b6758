#include "solvers/pagmo.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/compass_search.hpp>
#include <pagmo/algorithms/cstrs_self_adaptive.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/config.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/utils/hypervolume.hpp>
#include <string>
#include <utility>

#include "ricochet/random.h"
#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"
#include "solvers/unit_box.h"

/// Code shared by the solvers of pagmo.
namespace ricochet {

/// Number of generations: until the evaluator refuses.
inline constexpr unsigned endless = std::numeric_limits<unsigned>::max();

inline constexpr double pagmo_step_tolerance = 1e-8;  // of the box
/// Difference between the best and the worst value of a generation: only 0 is below.
inline constexpr double pagmo_value_tolerance = std::numeric_limits<double>::min();

/// The termination reason if pagmo's own criteria ended the search.
inline constexpr const char* converged = "converged";

/// Objective and constraints of a point without finite values. Some of pagmo's algorithms take
/// squares.
inline constexpr double without_a_number = 1e100;

/// A problem over the unit cube with pagmo's interface: objective, then equalities, then
/// inequalities <= 0. pagmo copies it. If the evaluator refuses, it throws, which ends pagmo at
/// once; the solvers of pagmo_solver() catch that.
class UnitProblem {
 public:
  explicit UnitProblem(UnitBox* box = nullptr) : box_(box) {}

  pagmo::vector_double fitness(const pagmo::vector_double& u) const;
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const;
  pagmo::vector_double::size_type get_nec() const;
  pagmo::vector_double::size_type get_nic() const;

 private:
  UnitBox* box_;
};

/// pagmo's seeds have 32 bits.
unsigned seed_from(Random& random);

/// The start, and points uniform in the box, `size` in all.
pagmo::population population_of(UnitBox& box, const Vector& start, Eigen::Index size,
                                Random& random);

/// Default number of points of a population: 10 n, at least 20 and at most 100.
Eigen::Index usual_size(Eigen::Index n);
inline constexpr const char* usual_size_in_words = "10 n, from 20 to 100";

/// Number of points of an evolution strategy: 4 + floor(3 ln n), at least the 5 that pagmo
/// requires.
Eigen::Index evolution_size(Eigen::Index n);
inline constexpr const char* evolution_size_in_words = "4 + floor(3 ln n), at least 5";

using Minimise =
    std::function<SolverTermination(Evaluator& evaluator, const Vector& start, Random& random)>;

Solver pagmo_solver(const std::string& name, const Capabilities& capabilities, Minimise minimise);

/// The given population size, or else `usual`.
Eigen::Index size_of(const GivenOptions& given, Eigen::Index usual);

/// The option "population"; `usual` describes its default in words.
SolverOption population_option(int least, const std::string& usual);

namespace {

/// Thrown through pagmo.
struct Refused {};

}  // namespace

pagmo::vector_double UnitProblem::fitness(const pagmo::vector_double& u) const {
  const auto values = box_->values(Eigen::Map<const Vector>(u.data(), std::ssize(u)));
  if (box_->over()) throw Refused();
  pagmo::vector_double result(1 + static_cast<std::size_t>(box_->evaluator().constraints()),
                              without_a_number);
  if (values && finite(*values)) {
    result.front() = values->objective;
    std::copy(values->constraints.begin(), values->constraints.end(), result.begin() + 1);
  }
  return result;
}

std::pair<pagmo::vector_double, pagmo::vector_double> UnitProblem::get_bounds() const {
  const auto n = static_cast<std::size_t>(box_ ? box_->evaluator().dimension() : 1);
  return {pagmo::vector_double(n, 0.0), pagmo::vector_double(n, 1.0)};
}

pagmo::vector_double::size_type UnitProblem::get_nec() const {
  return box_ ? static_cast<std::size_t>(box_->evaluator().equalities()) : 0;
}

pagmo::vector_double::size_type UnitProblem::get_nic() const {
  return box_ ? static_cast<std::size_t>(box_->evaluator().constraints()) - get_nec() : 0;
}

unsigned seed_from(Random& random) {
  return static_cast<unsigned>(random());
}

pagmo::population population_of(UnitBox& box, const Vector& start, Eigen::Index size,
                                Random& random) {
  const Evaluator& evaluator = box.evaluator();
  pagmo::problem shown{UnitProblem(&box)};
  shown.set_c_tol(pagmo::vector_double(shown.get_nc(), constraint_tolerance));
  pagmo::population population(shown, 0, seed_from(random));
  Vector x = start;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Vector u = box.to_unit(x).cwiseMax(0.0).cwiseMin(1.0);
    population.push_back(pagmo::vector_double(u.begin(), u.end()));
    x = uniform_point(evaluator.lower(), evaluator.upper(), random);
  }
  return population;
}

Eigen::Index usual_size(Eigen::Index n) {
  return std::clamp<Eigen::Index>(10 * n, 20, 100);
}

Eigen::Index evolution_size(Eigen::Index n) {
  return std::max<Eigen::Index>(5, 4 + static_cast<Eigen::Index>(3 * std::log(n)));
}

Eigen::Index size_of(const GivenOptions& given, Eigen::Index usual) {
  return whole_of(given, "population", static_cast<int>(usual));
}

SolverOption population_option(int least, const std::string& usual) {
  SolverOption option = whole_option("population", least, usual);
  option.most = 1e4;
  return option;
}

Solver pagmo_solver(const std::string& name, const Capabilities& capabilities, Minimise minimise) {
  Solver solver;
  solver.name = "pagmo-" + name;
  solver.version = "pagmo " PAGMO_VERSION;
  solver.stochastic = true;
  solver.capabilities = capabilities;
  solver.solve = [minimise = std::move(minimise)](Evaluator& evaluator, const Vector& start,
                                                  Random& random) -> SolverTermination {
    try {
      return minimise(evaluator, start, random);
    } catch (const Refused&) {
      return {stopped_by_evaluator};
    }
  };
  return solver;
}

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
