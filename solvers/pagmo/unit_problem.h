#pragma once

#include <functional>
#include <limits>
#include <pagmo/population.hpp>
#include <string>
#include <utility>

#include "solvers/adjustable_solver.h"
#include "solvers/unit_box.h"
#include "src/core/solver.h"

/// What the solvers of pagmo have in common.
namespace ricochet {

/// Generations until the evaluator refuses.
inline constexpr unsigned endless = std::numeric_limits<unsigned>::max();

inline constexpr double pagmo_step_tolerance = 1e-8;  // of the box
/// Between the best and the worst value of a generation: none but 0 is below.
inline constexpr double pagmo_value_tolerance = std::numeric_limits<double>::min();

/// What a solver says when pagmo's criteria ended it.
inline constexpr const char* converged = "converged";

/// What a point without a number counts as, by objective and constraints. Some of pagmo's
/// algorithms take squares.
inline constexpr double without_a_number = 1e100;

/// A problem over the unit cube, as pagmo wants to be told: objective, then equalities, then
/// inequalities <= 0. pagmo copies it. Where the evaluator refuses it throws, which ends pagmo at
/// once; the solvers of pagmo_solver() catch that.
class UnitProblem {
 public:
  explicit UnitProblem(UnitBox* box = nullptr, const Problem* problem = nullptr)
      : box_(box), problem_(problem) {}

  pagmo::vector_double fitness(const pagmo::vector_double& u) const;
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const;
  pagmo::vector_double::size_type get_nec() const;
  pagmo::vector_double::size_type get_nic() const;

 private:
  UnitBox* box_;
  const Problem* problem_;
};

/// pagmo's seeds have 32 bits.
unsigned seed_from(Random& random);

/// The start, and points uniform in the box, `size` in all.
pagmo::population population_of(UnitBox& box, const Problem& problem, const Vector& start,
                                Eigen::Index size, Random& random);

/// Points of a population: 10 n, but 20 at least and 100 at most.
Eigen::Index usual_size(Eigen::Index n);
inline constexpr const char* usual_size_in_words = "10 n, from 20 to 100";

/// Points of an evolution strategy: 4 + floor(3 ln n), at least the 5 that pagmo wants.
Eigen::Index evolution_size(Eigen::Index n);
inline constexpr const char* evolution_size_in_words = "4 + floor(3 ln n), at least 5";

/// Which problems a solver takes.
enum class Takes { unconstrained, constrained, both };

using Minimise =
    std::function<SolverExit(Evaluator& evaluator, const Vector& start, Random& random)>;

Solver pagmo_solver(const std::string& name, Takes takes, Minimise minimise);

/// Points of a population, where they are given, or else the usual.
Eigen::Index size_of(const GivenOptions& given, Eigen::Index usual);

/// The option of that; `usual` in words.
SolverOption population_option(int least, const std::string& usual);

}  // namespace ricochet
