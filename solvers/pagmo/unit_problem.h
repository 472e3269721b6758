#pragma once

#include <functional>
#include <limits>
#include <pagmo/population.hpp>
#include <string>
#include <utility>

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

}  // namespace ricochet
