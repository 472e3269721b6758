#include "solvers/pagmo/unit_problem.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <pagmo/config.hpp>
#include <pagmo/problem.hpp>
#include <utility>

#include "ricochet/random.h"

namespace ricochet {
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

}  // namespace ricochet
