#include "solvers/pagmo.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
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
#include "solvers/scaled_box.h"

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
  explicit UnitProblem(ScaledBox* box = nullptr) : box_(box) {}

  pagmo::vector_double fitness(const pagmo::vector_double& u) const;
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const;
  pagmo::vector_double::size_type get_nec() const;
  pagmo::vector_double::size_type get_nic() const;

 private:
  ScaledBox* box_;
};

/// pagmo's seeds have 32 bits.
unsigned seed_from(Random& random);

/// The start, and points uniform in the box, `size` in all.
pagmo::population population_of(ScaledBox& box, const Vector& start, Eigen::Index size,
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

/// The population size given, or else `usual`.
Eigen::Index size_of(const std::optional<int>& given, Eigen::Index usual) {
  return given ? *given : usual;
}

/// The option "population"; `usual` describes its default in words.
constexpr Field population_option(int least, const char* usual) {
  return whole_option("population", least, 1e4, usual);
}

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

pagmo::population population_of(ScaledBox& box, const Vector& start, Eigen::Index size,
                                Random& random) {
  const Evaluator& evaluator = box.evaluator();
  pagmo::problem shown{UnitProblem(&box)};
  shown.set_c_tol(pagmo::vector_double(shown.get_nc(), constraint_tolerance));
  pagmo::population population(shown, 0, seed_from(random));
  Vector x = start;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Vector u = box.to_scaled(x);
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

constexpr Field step_option = [] {
  Field field = real_option("initial_step", 0, 1);
  field.range.without_least = true;
  return field;
}();

struct CmaesOptions {
  double initial_step = own_step;
  std::optional<int> population = {};
};

template <class Visit, IsOf<CmaesOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(step_option, o.initial_step...);
  visit(population_option(5, evolution_size_in_words), o.population...);
}

struct RestartedCmaesOptions {
  CmaesOptions cmaes = {};
  int growth = 2;  ///< of the population at every restart
};

template <class Visit, IsOf<RestartedCmaesOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit_fields(visit, o.cmaes...);
  visit(whole_option("growth", 1, 10), o.growth...);
}

/// One run, until it converges.
void run_cmaes(ScaledBox& box, const Vector& start, Eigen::Index size, double initial_step,
               Random& random) {
  const pagmo::population population = population_of(box, start, size, random);
  constexpr double automatic = -1;
  pagmo::cmaes(endless, automatic, automatic, automatic, automatic, initial_step,
               pagmo_value_tolerance, pagmo_step_tolerance, false, true, seed_from(random))
      .evolve(population);
}

Solver cmaes(const std::string& name, const CmaesOptions& options) {
  return pagmo_solver(
      name, pagmo_bounds_only,
      [=](Evaluator& evaluator, const Vector& start, Random& random) -> SolverTermination {
        ScaledBox box(evaluator);
        run_cmaes(box, start, size_of(options.population, evolution_size(start.size())),
                  options.initial_step, random);
        return {converged};
      });
}

Solver cmaes_ipop(const std::string& name, const RestartedCmaesOptions& options) {
  Solver solver = pagmo_solver(
      name, pagmo_bounds_only,
      [=](Evaluator& evaluator, const Vector& start, Random& random) -> SolverTermination {
        ScaledBox box(evaluator);
        Vector from = start;
        for (Eigen::Index size = size_of(options.cmaes.population, evolution_size(start.size()));;
             size *= options.growth) {
          run_cmaes(box, from, size, options.cmaes.initial_step, random);
          from = uniform_point(evaluator.lower(), evaluator.upper(), random);
        }
      });
  // The first was what is now pagmo-cmaes-ipop-tuned.
  if (name == "cmaes-ipop") solver.version += " (adapter 2)";
  return solver;
}

constexpr RestartedCmaesOptions tuned_restarts = {.cmaes = {.initial_step = tuned_step}};

}  // namespace

Solver pagmo_cmaes(Settings settings) {
  return settings == Settings::tuned ? cmaes("cmaes-tuned", {.initial_step = tuned_step})
                                     : cmaes("cmaes", {});
}

Solver pagmo_cmaes_ipop(Settings settings) {
  return settings == Settings::tuned ? cmaes_ipop("cmaes-ipop-tuned", tuned_restarts)
                                     : cmaes_ipop("cmaes-ipop", {});
}

std::vector<AdjustableSolver> adjustable_pagmo_cmaes() {
  const auto named = [](const char* name) {
    return [=](const CmaesOptions& options) { return cmaes(name, options); };
  };
  const auto restarted = [](const char* name) {
    return [=](const RestartedCmaesOptions& options) { return cmaes_ipop(name, options); };
  };
  const CmaesOptions tuned = {.initial_step = tuned_step};
  return {adjustable("pagmo-cmaes", CmaesOptions(), named("cmaes")),
          adjustable("pagmo-cmaes-tuned", tuned, named("cmaes-tuned")),
          adjustable("pagmo-cmaes-ipop", RestartedCmaesOptions(), restarted("cmaes-ipop")),
          adjustable("pagmo-cmaes-ipop-tuned", tuned_restarts, restarted("cmaes-ipop-tuned"))};
}

namespace {

struct CompassOptions {
  double initial_step = 0.25;  ///< of the box
  double shrinkage = 0.5;
};

template <class Visit, IsOf<CompassOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(real_option("initial_step", 1e-6, 1), o.initial_step...);
  visit(real_option("shrinkage", 0.01, 0.99), o.shrinkage...);
}

Solver compass_search(const CompassOptions& options) {
  Solver solver = pagmo_solver(
      "compass-search", pagmo_all_constraints,
      [=](Evaluator& evaluator, const Vector& start, Random& random) -> SolverTermination {
        ScaledBox box(evaluator);
        pagmo::compass_search(endless, options.initial_step, pagmo_step_tolerance,
                              options.shrinkage)
            .evolve(population_of(box, start, 1, random));
        return {converged};
      });
  solver.stochastic = false;
  return solver;
}

}  // namespace

Solver pagmo_compass_search() {
  return compass_search({});
}

AdjustableSolver adjustable_pagmo_compass_search() {
  return adjustable("pagmo-compass-search", CompassOptions(), compass_search);
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

struct ConstrainedEvolutionOptions {
  double weight = 0.8, crossover = 0.9;  ///< pagmo's own defaults, as is the rest
  std::optional<int> population = {};
};

template <class Visit, IsOf<ConstrainedEvolutionOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(real_option("weight", 0, 1), o.weight...);
  visit(real_option("crossover", 0, 1), o.crossover...);
  visit(population_option(5, usual_size_in_words), o.population...);
}

/// The population of a search from this start: of the size given, or else the usual one.
pagmo::population population_of(ScaledBox& box, const Vector& start, const std::optional<int>& size,
                                Random& random) {
  return population_of(box, start, size_of(size, usual_size(start.size())), random);
}

SolverTermination minimise_constrained(const ConstrainedEvolutionOptions& options,
                                       Evaluator& evaluator, const Vector& start, Random& random) {
  ScaledBox box(evaluator);
  pagmo::population population = population_of(box, start, options.population, random);
  constexpr unsigned rand_1_exp = 2;
  const pagmo::de generation(1, options.weight, options.crossover, rand_1_exp, 0.0, 0.0,
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

Solver constrained_de(const ConstrainedEvolutionOptions& options) {
  return pagmo_solver("constrained-de", pagmo_needs_constraints,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_constrained(options, evaluator, start, random);
                      });
}

}  // namespace

Solver pagmo_constrained_de() {
  return constrained_de({});
}

AdjustableSolver adjustable_pagmo_constrained_de() {
  return adjustable("pagmo-constrained-de", ConstrainedEvolutionOptions(), constrained_de);
}

namespace {

/// Options of pagmo's kinds of differential evolution, with its own defaults.
struct EvolutionOptions {
  double weight = 0.8, crossover = 0.9;
  unsigned variant = 2;     ///< rand/1/exp
  unsigned adaptation = 1;  ///< jDE
  std::optional<int> population = {};
};

pagmo::de plain(const EvolutionOptions& options, unsigned seed) {
  return pagmo::de(endless, options.weight, options.crossover, options.variant,
                   pagmo_value_tolerance, pagmo_step_tolerance, seed);
}

pagmo::sade adapting(const EvolutionOptions& options, unsigned seed) {
  return pagmo::sade(endless, options.variant, options.adaptation, pagmo_value_tolerance,
                     pagmo_step_tolerance, false, seed);
}

pagmo::de1220 choosing(const EvolutionOptions& options, unsigned seed) {
  return pagmo::de1220(endless, pagmo::de1220_statics<void>::allowed_variants, options.adaptation,
                       pagmo_value_tolerance, pagmo_step_tolerance, false, seed);
}

template <auto algorithm>
struct EvolutionBy {
  EvolutionOptions options = {};
};

template <class Visit, IsOf<EvolutionBy<plain>>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(real_option("weight", 0, 1), o.options.weight...);
  visit(real_option("crossover", 0, 1), o.options.crossover...);
  visit(whole_option("variant", 1, 10), o.options.variant...);
  visit(population_option(5, usual_size_in_words), o.options.population...);
}

constexpr Field adaptation_option = whole_option("adaptation", 1, 2);
constexpr Field evolving_option = population_option(7, usual_size_in_words);

template <class Visit, IsOf<EvolutionBy<adapting>>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(whole_option("variant", 1, 18), o.options.variant...);
  visit(adaptation_option, o.options.adaptation...);
  visit(evolving_option, o.options.population...);
}

template <class Visit, IsOf<EvolutionBy<choosing>>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(adaptation_option, o.options.adaptation...);
  visit(evolving_option, o.options.population...);
}

template <auto algorithm>
Solver made(const std::string& name, const EvolutionBy<algorithm>& by) {
  return pagmo_solver(name, pagmo_bounds_only,
                      [options = by.options](Evaluator& evaluator, const Vector& start,
                                             Random& random) -> SolverTermination {
                        ScaledBox box(evaluator);
                        const pagmo::population population =
                            population_of(box, start, options.population, random);
                        algorithm(options, seed_from(random)).evolve(population);
                        return {converged};
                      });
}

template <auto algorithm>
AdjustableSolver adjustable_evolution(const std::string& name) {
  return adjustable("pagmo-" + name, EvolutionBy<algorithm>(),
                    [name](const EvolutionBy<algorithm>& by) { return made(name, by); });
}

}  // namespace

Solver pagmo_de() {
  return made("de", EvolutionBy<plain>());
}

Solver pagmo_sade() {
  return made("sade", EvolutionBy<adapting>());
}

Solver pagmo_de1220() {
  return made("de1220", EvolutionBy<choosing>());
}

std::vector<AdjustableSolver> adjustable_pagmo_de() {
  return {adjustable_evolution<plain>("de"), adjustable_evolution<adapting>("sade"),
          adjustable_evolution<choosing>("de1220")};
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

struct AntColonyOptions {
  std::optional<int> population = {}, kernel = {};
};

template <class Visit, IsOf<AntColonyOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(population_option(10, usual_size_in_words), o.population...);
  visit(whole_option("kernel", 2, 1e6, "the population; it is never more"), o.kernel...);
}

SolverTermination minimise_by_gaco(const AntColonyOptions& options, Evaluator& evaluator,
                                   const Vector& start, Random& random) {
  ScaledBox box(evaluator);
  const pagmo::population population = population_of(box, start, options.population, random);
  const int size = static_cast<int>(population.size());
  constexpr double spread = 1;    // pagmo's own default
  constexpr double accuracy = 0;  // two values differ if they are not equal
  constexpr unsigned threshold = 1, marks = 7, never = 0;  // pagmo's own defaults
  const int kernel = std::min(options.kernel.value_or(size), size);
  pagmo::gaco(endless, static_cast<unsigned>(kernel), spread, highest(population), accuracy,
              threshold, marks, never, never, 0.0, false, seed_from(random))
      .evolve(population);
  return {converged};
}

Solver gaco(const AntColonyOptions& options) {
  return pagmo_solver("gaco", pagmo_all_constraints,
                      [=](Evaluator& evaluator, const Vector& start, Random& random) {
                        return minimise_by_gaco(options, evaluator, start, random);
                      });
}

}  // namespace

Solver pagmo_gaco() {
  return gaco({});
}

AdjustableSolver adjustable_pagmo_gaco() {
  return adjustable("pagmo-gaco", AntColonyOptions(), gaco);
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

struct XnesOptions {
  std::optional<double> initial_step = {};
  std::optional<int> population = {};
};

template <class Visit, IsOf<XnesOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  Field step = step_option;
  step.remark = "pagmo's";
  visit(step, o.initial_step...);
  visit(population_option(4, evolution_size_in_words), o.population...);
}

Solver xnes(const XnesOptions& options) {
  return pagmo_solver(
      "xnes", pagmo_bounds_only,
      [=](Evaluator& evaluator, const Vector& start, Random& random) -> SolverTermination {
        ScaledBox box(evaluator);
        const Eigen::Index size = size_of(options.population, evolution_size(start.size()));
        const pagmo::population population = population_of(box, start, size, random);
        pagmo::xnes(endless, automatic, automatic, automatic,
                    options.initial_step.value_or(automatic), pagmo_value_tolerance,
                    pagmo_step_tolerance, false, true, seed_from(random))
            .evolve(population);
        return {converged};
      });
}

}  // namespace

Solver pagmo_xnes() {
  return xnes({});
}

AdjustableSolver adjustable_pagmo_xnes() {
  return adjustable("pagmo-xnes", XnesOptions(), xnes);
}

}  // namespace ricochet
