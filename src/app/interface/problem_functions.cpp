#include "src/app/interface/problem_functions.h"

#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "ricochet/error.h"
#include "src/app/interface/interface.h"

/// What ricochet.h asks of an open problem by functions.
namespace ricochet::interface {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The variable, or null if the problem gives its variables no names.
const Variable* variable_of(const Problem& problem, std::int32_t index) {
  if (index < 0 || index >= problem.dimension()) {
    throw InputError(
        fmt::format("variable {}: must be from 0 to {}", index, problem.dimension() - 1));
  }
  return problem.variables.empty() ? nullptr : &problem.variables[static_cast<std::size_t>(index)];
}

void write(const double* from, std::int32_t size, double* to) {
  if (to) std::copy_n(from, size, to);
}

}  // namespace

}  // namespace ricochet::interface

using namespace ricochet::interface;

RICOCHET_EXPORTED const char* ricochet_name(const ricochet_problem* problem) {
  return open_problems().ask<const char*>(problem, nullptr,
                                          [](OpenedProblem& at) { return at.name; });
}

RICOCHET_EXPORTED const char* ricochet_unit(const ricochet_problem* problem) {
  return open_problems().ask<const char*>(
      problem, nullptr, [](OpenedProblem& at) { return at.stated().unit.c_str(); });
}

RICOCHET_EXPORTED std::int32_t ricochet_dimension(const ricochet_problem* problem) {
  return open_problems().ask(problem, -1, [](OpenedProblem& at) { return at.dimension; });
}

RICOCHET_EXPORTED std::int32_t ricochet_constraints(const ricochet_problem* problem) {
  return open_problems().ask(problem, -1, [](OpenedProblem& at) { return at.constraints; });
}

RICOCHET_EXPORTED std::int32_t ricochet_equalities(const ricochet_problem* problem) {
  return open_problems().ask(problem, -1, [](OpenedProblem& at) { return at.equalities; });
}

RICOCHET_EXPORTED std::int32_t ricochet_has_derivatives(const ricochet_problem* problem) {
  return open_problems().ask(problem, -1, [](OpenedProblem& at) { return at.has_derivatives; });
}

RICOCHET_EXPORTED std::int32_t ricochet_has_residuals(const ricochet_problem* problem) {
  return open_problems().ask(problem, -1, [](OpenedProblem& at) { return at.has_residuals; });
}

RICOCHET_EXPORTED std::int32_t ricochet_bounds(const ricochet_problem* problem, double* lower,
                                               double* upper) {
  return open_problems().ask(problem, 1, [&](OpenedProblem& at) {
    write(at.lower, at.dimension, lower);
    write(at.upper, at.dimension, upper);
    return 0;
  });
}

RICOCHET_EXPORTED std::int32_t ricochet_start(const ricochet_problem* problem, double* start) {
  return open_problems().ask(problem, 1, [&](OpenedProblem& at) {
    write(at.start, at.dimension, start);
    return 0;
  });
}

RICOCHET_EXPORTED const char* ricochet_variable_name(const ricochet_problem* problem,
                                                     std::int32_t index) {
  return open_problems().ask<const char*>(problem, nullptr, [&](OpenedProblem& at) {
    const auto* const variable = variable_of(at.stated(), index);
    return variable ? variable->name.c_str() : "";
  });
}

RICOCHET_EXPORTED const char* ricochet_variable_unit(const ricochet_problem* problem,
                                                     std::int32_t index) {
  return open_problems().ask<const char*>(problem, nullptr, [&](OpenedProblem& at) {
    const auto* const variable = variable_of(at.stated(), index);
    return variable ? variable->unit.c_str() : "";
  });
}

RICOCHET_EXPORTED double ricochet_best_known(const ricochet_problem* problem) {
  return open_problems().ask(
      problem, unknown, [](OpenedProblem& at) { return at.stated().best_known.value_or(unknown); });
}

RICOCHET_EXPORTED double ricochet_tolerance(const ricochet_problem* problem) {
  return open_problems().ask(problem, unknown,
                             [](OpenedProblem& at) { return at.stated().tolerance; });
}

RICOCHET_EXPORTED std::int32_t ricochet_values(ricochet_problem* problem, const double* x,
                                               double* objective, double* constraints) {
  return open_problems().ask(
      problem, 1, [&](OpenedProblem& at) { return at.values(&at, x, objective, constraints); });
}

RICOCHET_EXPORTED std::int64_t ricochet_values_batch(ricochet_problem* problem,
                                                     const double* points, std::int64_t count,
                                                     double* objectives, double* constraints) {
  return open_problems().ask(problem, std::int64_t{0}, [&](OpenedProblem& at) {
    for (std::int64_t k = 0; k < count; ++k) {
      const double* const x = points ? points + k * at.dimension : nullptr;
      if (at.values(&at, x, objectives ? objectives + k : nullptr,
                    constraints ? constraints + k * at.constraints : nullptr)) {
        return k;
      }
    }
    return std::max(count, std::int64_t{0});
  });
}

RICOCHET_EXPORTED std::int32_t ricochet_derivatives(ricochet_problem* problem, const double* x,
                                                    double* objective, double* constraints,
                                                    double* gradient, double* jacobian) {
  return open_problems().ask(problem, 1, [&](OpenedProblem& at) {
    return at.derivatives(&at, x, objective, constraints, gradient, jacobian);
  });
}

RICOCHET_EXPORTED std::int32_t ricochet_residual_count(ricochet_problem* problem, const double* x) {
  return open_problems().ask(problem, 0,
                             [&](OpenedProblem& at) { return at.residual_count(&at, x); });
}

RICOCHET_EXPORTED std::int32_t ricochet_residuals(ricochet_problem* problem, const double* x,
                                                  double* residuals, double* jacobian) {
  return open_problems().ask(
      problem, 1, [&](OpenedProblem& at) { return at.residuals(&at, x, residuals, jacobian); });
}

RICOCHET_EXPORTED std::int32_t ricochet_judge(ricochet_problem* problem, const double* x,
                                              double* objective, double* violation) {
  return open_problems().ask(problem, 1, [&](OpenedProblem& at) {
    const ricochet::TrueValues true_values = at.judge(x);
    if (objective) *objective = true_values.objective;
    if (violation) *violation = true_values.violation;
    return 0;
  });
}

RICOCHET_EXPORTED std::int64_t ricochet_remaining(ricochet_problem* problem) {
  return open_problems().ask(problem, std::int64_t{-1},
                             [](OpenedProblem& at) { return at.remaining(&at); });
}

RICOCHET_EXPORTED double ricochet_uniform(ricochet_problem* problem) {
  return open_problems().ask(problem, unknown, [](OpenedProblem& at) { return at.uniform(&at); });
}

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
