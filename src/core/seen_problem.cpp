#include "src/core/seen_problem.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "src/core/floating_point.h"

namespace ricochet::interface {

namespace {

/// Copies to the caller's array, unless it is null.
void write(const Vector& values, double* to) {
  if (to) std::copy(values.begin(), values.end(), to);
}

void write(double value, double* to) {
  if (to) *to = value;
}

/// Writes in row-major order.
void write_rows(const Matrix& matrix, double* to) {
  if (!to) return;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) *to++ = matrix(row, column);
  }
}

/// The part that a caller requests: the objective, the constraints, or both.
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

SeenProblem::SeenProblem(Evaluator& evaluator, const Vector& from, Random& random)
    : ricochet_problem(),
      evaluator_(evaluator),
      random_(random),
      lower_(evaluator.lower()),
      upper_(evaluator.upper()),
      start_(from) {
  abi = RICOCHET_ABI;
  dimension = static_cast<std::int32_t>(evaluator.dimension());
  constraints = static_cast<std::int32_t>(evaluator.constraints());
  equalities = static_cast<std::int32_t>(evaluator.equalities());
  has_derivatives = evaluator.has_derivatives() ? 1 : 0;
  has_residuals = evaluator.has_residuals() ? 1 : 0;
  name = evaluator.name().c_str();
  lower = lower_.data();
  upper = upper_.data();
  start = start_.data();
  values = values_at;
  derivatives = derivatives_at;
  residual_count = count_residuals_at;
  residuals = residuals_at;
  remaining = evaluations_left;
  uniform = next_uniform;
}

bool SeenProblem::is_answered_here() {
  if (!thread_ || *thread_ == std::this_thread::get_id()) return true;
  asked_by_others_ = true;
  return false;
}

template <class Ask>
auto SeenProblem::told(const double* x, Ask ask) -> decltype(ask(Vector())) {
  if (!is_answered_here()) return std::nullopt;
  const DefaultFloatingPoint ours;
  try {
    if (!x) throw std::invalid_argument("the point asked for is NULL");
    point_ = Eigen::Map<const Vector>(x, evaluator_.dimension());
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
  if (!self.is_answered_here()) return 0;
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
  SeenProblem& self = seen(problem);
  return self.is_answered_here() ? self.evaluator_.remaining() : 0;
}

double SeenProblem::next_uniform(ricochet_problem* problem) {
  SeenProblem& self = seen(problem);
  if (!self.is_answered_here()) return std::numeric_limits<double>::quiet_NaN();
  const DefaultFloatingPoint ours;
  return ricochet::uniform(self.random_);
}

}  // namespace ricochet::interface
