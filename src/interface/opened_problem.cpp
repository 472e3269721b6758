#include "src/interface/opened_problem.h"

#include <fmt/format.h>

#include <stdexcept>

#include "src/interface/last_error.h"

namespace ricochet::interface {

template <class Result, class... Arguments, Result (*function)(ricochet_problem*, Arguments...),
          auto refused>
struct OpenedProblem::InTurn<function, refused> {
  static Result call(ricochet_problem* problem, Arguments... arguments) {
    const auto& self = *static_cast<OpenedProblem*>(problem);
    const std::lock_guard lock(self.mutex_);
    const Result result = function(problem, arguments...);
    if (result == refused) keep_error(self.reason());
    return result;
  }
};

OpenedProblem::OpenedProblem(Problem asked, std::int64_t budget, std::uint64_t seed)
    : OpenedRun(std::move(asked), budget, seed),
      SeenProblem(OpenedRun::evaluator, problem.start, OpenedRun::random),
      budget_(budget) {
  values = InTurn<&OpenedProblem::values_at, 1>::call;
  derivatives = InTurn<&OpenedProblem::derivatives_at, 1>::call;
  residual_count = InTurn<&OpenedProblem::count_residuals_at, 0>::call;
  residuals = InTurn<&OpenedProblem::residuals_at, 1>::call;
  remaining = InTurn<&OpenedProblem::evaluations_left, -1>::call;
  uniform = InTurn<&OpenedProblem::next_uniform, -1>::call;
}

TrueValues OpenedProblem::judge(const double* x) const {
  if (!x) throw std::invalid_argument("the point to be judged is NULL");
  const Eigen::Map<const Vector> point(x, problem.dimension());
  if (!point.allFinite()) {
    throw std::invalid_argument("the point to be judged has a coordinate that is not finite");
  }
  const std::lock_guard lock(mutex_);
  return true_values_at(problem, point.cwiseMax(problem.lower).cwiseMin(problem.upper));
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
