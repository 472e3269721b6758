#include "src/interface/opened_problem.h"

#include <fmt/format.h>

#include <stdexcept>

#include "src/interface/last_error.h"

namespace ricochet::interface {

OpenedProblem::OpenedProblem(Problem asked, std::int64_t budget, std::uint64_t seed)
    : OpenedRun(std::move(asked), budget, seed),
      SeenProblem(OpenedRun::evaluator, problem.start, OpenedRun::random),
      budget_(budget) {
  values = values_or_reason;
  derivatives = derivatives_or_reason;
  residual_count = residual_count_or_reason;
  residuals = residuals_or_reason;
}

TrueValues OpenedProblem::judge(const double* x) const {
  if (!x) throw std::invalid_argument("the point to be judged is NULL");
  const Eigen::Map<const Vector> point(x, problem.dimension());
  if (!point.allFinite()) {
    throw std::invalid_argument("the point to be judged has a coordinate that is not finite");
  }
  return true_values_at(problem, point.cwiseMax(problem.lower).cwiseMin(problem.upper));
}

std::int32_t OpenedProblem::values_or_reason(ricochet_problem* problem, const double* x,
                                             double* objective, double* constraints) {
  const std::int32_t over = values_at(problem, x, objective, constraints);
  if (over) keep_error(static_cast<OpenedProblem*>(problem)->reason());
  return over;
}

std::int32_t OpenedProblem::derivatives_or_reason(ricochet_problem* problem, const double* x,
                                                  double* objective, double* constraints,
                                                  double* gradient, double* jacobian) {
  const std::int32_t over = derivatives_at(problem, x, objective, constraints, gradient, jacobian);
  if (over) keep_error(static_cast<OpenedProblem*>(problem)->reason());
  return over;
}

std::int32_t OpenedProblem::residual_count_or_reason(ricochet_problem* problem, const double* x) {
  const std::int32_t count = count_residuals_at(problem, x);
  if (count == 0) keep_error(static_cast<OpenedProblem*>(problem)->reason());
  return count;
}

std::int32_t OpenedProblem::residuals_or_reason(ricochet_problem* problem, const double* x,
                                                double* residuals, double* jacobian) {
  const std::int32_t over = residuals_at(problem, x, residuals, jacobian);
  if (over) keep_error(static_cast<OpenedProblem*>(problem)->reason());
  return over;
}

std::exception_ptr OpenedProblem::reason() const {
  switch (OpenedRun::evaluator.termination_reason()) {
    case TerminationReason::bad_point:
      return std::make_exception_ptr(std::runtime_error(
          "the run is over: it asked for a point with a coordinate that is not finite"));
    case TerminationReason::failure:
      return OpenedRun::evaluator.failure();
    case TerminationReason::none:
      return failure();
    default:
      return std::make_exception_ptr(std::runtime_error(
          fmt::format("the run is over: its budget of {} evaluations is spent", budget_)));
  }
}

}  // namespace ricochet::interface
