#include "src/interface/seen_problem.h"

#include <algorithm>
#include <stdexcept>

namespace ricochet::interface {
namespace {

/// Copies to where a caller wants it, which is nowhere if null.
void write(const Vector& values, double* to) {
  if (to) std::copy(values.begin(), values.end(), to);
}

void write(double value, double* to) {
  if (to) *to = value;
}

/// Row by row.
void write_rows(const Matrix& matrix, double* to) {
  if (!to) return;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) *to++ = matrix(row, column);
  }
}

/// What a caller asks for who wants to know of the objective, of the constraints, or of both.
Part part_of(bool of_objective, bool of_constraints) {
  if (of_objective && !of_constraints) return Part::objective;
  if (!of_objective && of_constraints) {
    return static_cast<Part>(static_cast<unsigned>(Part::equalities) |
                             static_cast<unsigned>(Part::inequalities));
  }
  return Part::everything;
}

SeenProblem& seen(ricochet_problem* problem) {
  return *static_cast<SeenProblem*>(problem);
}

}  // namespace

SeenProblem::SeenProblem(Evaluator& evaluator, Random& random)
    : ricochet_problem(), evaluator_(evaluator), random_(random) {
  const Problem& problem = evaluator.problem();
  abi = RICOCHET_ABI;
  dimension = static_cast<std::int32_t>(problem.dimension());
  constraints = static_cast<std::int32_t>(problem.constraints);
  equalities = static_cast<std::int32_t>(problem.equalities);
  has_derivatives = problem.differentiate ? 1 : 0;
  has_residuals = problem.residuals ? 1 : 0;
  name = problem.name.c_str();
  lower = problem.lower.data();
  upper = problem.upper.data();
  start = problem.start.data();
  values = values_at;
  derivatives = derivatives_at;
  residual_count = count_residuals_at;
  residuals = residuals_at;
  remaining = evaluations_left;
  uniform = next_uniform;
}

template <class Ask>
auto SeenProblem::told(const double* x, Ask ask) -> decltype(ask(Vector())) {
  try {
    if (!x) throw std::invalid_argument("the point asked for is NULL");
    point_ = Eigen::Map<const Vector>(x, dimension);
    return ask(point_);
  } catch (...) {
    failure_ = std::current_exception();
    return std::nullopt;
  }
}

std::int32_t SeenProblem::values_at(ricochet_problem* problem, const double* x, double* objective,
                                    double* constraints) {
  SeenProblem& self = seen(problem);
  const Part part = part_of(objective, constraints);
  const auto told =
      self.told(x, [&](const Vector& at) { return self.evaluator_.values(at, part); });
  if (!told) return 1;
  write(told->objective, objective);
  write(told->constraints, constraints);
  return 0;
}

std::int32_t SeenProblem::derivatives_at(ricochet_problem* problem, const double* x,
                                         double* objective, double* constraints, double* gradient,
                                         double* jacobian) {
  SeenProblem& self = seen(problem);
  const Part part = part_of(objective || gradient, constraints || jacobian);
  const auto told =
      self.told(x, [&](const Vector& at) { return self.evaluator_.derivatives(at, part); });
  if (!told) return 1;
  write(told->values.objective, objective);
  write(told->values.constraints, constraints);
  write(told->gradient, gradient);
  write_rows(told->jacobian, jacobian);
  return 0;
}

std::int32_t SeenProblem::count_residuals_at(ricochet_problem* problem, const double* x) {
  SeenProblem& self = seen(problem);
  if (self.count_ > 0) return self.count_;
  const auto told = self.told(
      x, [&](const Vector& at) { return self.evaluator_.residual_values(at, Part::nothing); });
  if (told) self.keep_count(told->size());
  return self.count_;
}

std::int32_t SeenProblem::residuals_at(ricochet_problem* problem, const double* x,
                                       double* residuals, double* jacobian) {
  SeenProblem& self = seen(problem);
  if (!jacobian) {
    const auto told =
        self.told(x, [&](const Vector& at) { return self.evaluator_.residual_values(at); });
    if (!told) return 1;
    self.keep_count(told->size());
    write(*told, residuals);
    return 0;
  }
  const Part part = residuals ? Part::everything : Part::jacobian;
  const auto told =
      self.told(x, [&](const Vector& at) { return self.evaluator_.residuals(at, part); });
  if (!told) return 1;
  self.keep_count(told->values.size());
  write(told->values, residuals);
  write_rows(told->jacobian, jacobian);
  return 0;
}

std::int64_t SeenProblem::evaluations_left(ricochet_problem* problem) {
  return seen(problem).evaluator_.remaining();
}

double SeenProblem::next_uniform(ricochet_problem* problem) {
  return ricochet::uniform(seen(problem).random_);
}

}  // namespace ricochet::interface
