#include <fmt/format.h>
#include <ricochet/minimise.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "solvers/automatic.h"
#include "src/core/floating_point.h"
#include "src/core/names.h"

/// Solvers on a problem that a program fills in, see ricochet/minimise.h.
namespace ricochet::interface {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Of the box: for forward differences of residuals.
constexpr double difference_step = 1e-6;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Ends a run: the caller asked for it.
struct Stopped : std::exception {
  const char* what() const noexcept override { return "stopped by the function"; }
};

/// Throws InputError if it is false.
void require(bool holds, const std::string& otherwise) {
  if (!holds) throw InputError(otherwise);
}

Vector vector_of(const double* numbers, std::int32_t size, const char* name) {
  require(numbers != nullptr, fmt::format("{} is NULL", name));
  Vector vector = Eigen::Map<const Vector>(numbers, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    require(std::isfinite(vector[i]),
            fmt::format("{}[{}] = {}: must be finite", name, i, vector[i]));
  }
  return vector;
}

/// The problem of a caller, who is asked only while a solver runs: a run also looks at points that
/// a solver returns, which cost nothing and of which the best evaluated one is as good.
class CallersProblem {
 public:
  /// Throws InputError for what the caller must not fill in.
  explicit CallersProblem(ricochet_problem& from) : from_(from) {
    require(
        from.abi == RICOCHET_ABI,
        fmt::format("the problem is made for interface {}, this is {}", from.abi, RICOCHET_ABI));
    require(from.dimension >= 1, fmt::format("dimension {}: must be >= 1", from.dimension));
    require(from.equalities >= 0 && from.equalities <= from.constraints,
            fmt::format("equalities {}: must be from 0 to the number of constraints, {}",
                        from.equalities, from.constraints));
    require(from.values != nullptr, "values is NULL");
    require(!from.has_derivatives || from.derivatives, "derivatives is NULL");
    require(!from.has_residuals || (from.residuals && from.residual_count),
            "residuals or residual_count is NULL");
    problem_.name = from.name ? from.name : "problem";
    require(is_name(problem_.name),
            fmt::format("name \"{}\"; allowed are {}", one_line(problem_.name), names_in_words));
    problem_.lower = vector_of(from.lower, from.dimension, "lower");
    problem_.upper = vector_of(from.upper, from.dimension, "upper");
    problem_.start = vector_of(from.start, from.dimension, "start");
    for (Eigen::Index i = 0; i < from.dimension; ++i) {
      const double lower = problem_.lower[i], upper = problem_.upper[i], start = problem_.start[i];
      require(lower <= upper,
              fmt::format("upper[{}] = {}: must be >= lower[{}] = {}", i, upper, i, lower));
      require(lower <= start && start <= upper,
              fmt::format("start[{}] = {}: must be from {} to {}", i, start, lower, upper));
    }
    point_ = residuals_at_ = Vector::Constant(from.dimension, missing);
    problem_.constraints = from.constraints;
    problem_.equalities = from.equalities;
    problem_.start_scales = {1};  // whatever the seed, the first start is the caller's
    problem_.evaluate = [this](const Vector& x) { return values(x); };
    if (from.has_derivatives) {
      problem_.differentiate = [this](const Vector& x) { return derivatives(x); };
    }
    if (from.has_residuals && from.constraints == 0) {
      const std::int32_t count = from.residual_count(&from, from.start);
      require(count >= 1, fmt::format("residual_count {}: must be >= 1", count));
      residuals_.resize(count);
      problem_.residuals = [this](const Vector& x) { return residuals(x); };
      if (!from.has_derivatives) {
        problem_.residual_values = [this](const Vector& x) { return residual_values(x); };
      }
    }
  }
  CallersProblem(const CallersProblem&) = delete;  // its functions know where it is
  CallersProblem& operator=(const CallersProblem&) = delete;

  Problem& problem() { return problem_; }
  std::int64_t failed() const { return failed_; }

  /// The solver, which may ask the caller while it runs.
  Solver asking(Solver solver) {
    solver.solve = [this, solve = std::move(solver.solve)](Evaluator& evaluator,
                                                           const Vector& start, Random& random) {
      asked_ = true;
      SolverTermination exit = solve(evaluator, start, random);
      asked_ = false;
      return exit;
    };
    return solver;
  }

  /// True values, for a formulation or residuals, whose values are others: those of the last point,
  /// without asking the caller again.
  void score_by_last_values() {
    problem_.true_values = [this](const Vector& x) {
      return x == point_ ? true_values_of(last_, problem_.equalities)
                         : TrueValues{missing, missing};
    };
  }

 private:
  /// Makes x the last point. Its values are not known yet.
  void move_to(const Vector& x) {
    point_ = x;
    last_ = {missing, Vector::Constant(problem_.constraints, missing)};
  }

  /// What the caller returned for numbers of which any may be NaN; `clear` makes all so.
  template <class Clear>
  void answered(std::int32_t code, bool complete, const Clear& clear) {
    if (code < 0) throw Stopped();
    if (code > 0) clear();
    if (code > 0 || !complete) ++failed_;
  }

  Values values(const Vector& x) {
    move_to(x);
    if (!asked_) return last_;
    const std::int32_t code =
        from_.values(&from_, point_.data(), &last_.objective, last_.constraints.data());
    answered(code, is_complete(), [&] { move_to(x); });
    return last_;
  }

  Derivatives derivatives(const Vector& x) {
    move_to(x);
    gradient_ = Vector::Constant(x.size(), missing);
    jacobian_ = Rows::Constant(problem_.constraints, x.size(), missing);
    const std::int32_t code =
        from_.derivatives(&from_, point_.data(), &last_.objective, last_.constraints.data(),
                          gradient_.data(), jacobian_.data());
    answered(code, is_complete() && !gradient_.hasNaN() && !jacobian_.hasNaN(), [&] {
      move_to(x);
      gradient_.setConstant(missing);
      jacobian_.setConstant(missing);
    });
    return {last_, gradient_, jacobian_};
  }

  Vector residual_values(const Vector& x) {
    move_to(x);
    ask_residuals(x, nullptr);
    last_.objective = residuals_.squaredNorm() / 2;
    return residuals_;
  }

  Residuals residuals(const Vector& x) {
    Residuals result;
    if (from_.has_derivatives) {
      move_to(x);
      residual_jacobian_ = Rows::Constant(residuals_.size(), x.size(), missing);
      ask_residuals(x, residual_jacobian_.data());
      result = {residuals_, residual_jacobian_};
    } else {
      const bool known = residuals_at_ == x;
      result = {known ? residuals_ : residual_values(x), Matrix::Zero(residuals_.size(), x.size())};
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double step = difference_step * (problem_.upper[i] - problem_.lower[i]);
        Vector beside = x;
        beside[i] += x[i] + step > problem_.upper[i] ? -step : step;
        if (beside[i] == x[i]) continue;  // the box has no width there
        ask_residuals(beside, nullptr);
        result.jacobian.col(i) = (residuals_ - result.values) / (beside[i] - x[i]);
      }
      move_to(x);
      residuals_ = result.values;
      residuals_at_ = x;
    }
    last_.objective = result.values.squaredNorm() / 2;
    return result;
  }

  void ask_residuals(const Vector& x, double* jacobian) {
    point_ = residuals_at_ = x;  // always read from the same place
    residuals_.setConstant(missing);
    const std::int32_t code = from_.residuals(&from_, point_.data(), residuals_.data(), jacobian);
    const bool complete = !residuals_.hasNaN() && !(jacobian && residual_jacobian_.hasNaN());
    answered(code, complete, [&] {
      residuals_.setConstant(missing);
      if (jacobian) residual_jacobian_.setConstant(missing);
    });
  }

  bool is_complete() const { return !std::isnan(last_.objective) && !last_.constraints.hasNaN(); }

  ricochet_problem& from_;
  Problem problem_;
  bool asked_ = false;
  std::int64_t failed_ = 0;
  Vector point_;  // the last one
  Values last_;   // at that point, as far as they were told
  Vector gradient_, residuals_;
  Vector residuals_at_;  // the point of the residuals
  Rows jacobian_, residual_jacobian_;
};

/// The first formulation that the solver accepts. Throws InputError if there is none.
Problem accepted_formulation(const Problem& problem, const Solver& solver) {
  for (const Formulation& formulation : problem.formulations()) {
    Problem formulated = problem.formulated(formulation);
    if (solver.accepts(formulated)) return formulated;
  }
  const Capabilities& can = solver.capabilities;
  throw InputError(fmt::format(
      "{} does not take the problem: variables: {}; constraints: {}; needs: {}", solver.name,
      can.variables_in_words(), can.constraints_in_words(), can.needs_in_words()));
}

std::string ending_of(const RunRecord& record) {
  if (!record.failure.empty()) return record.failure;
  std::string text = record.termination_reason == TerminationReason::evaluations
                         ? "the budget is spent"
                         : "the solver finds no other point";
  const std::size_t starts = record.terminations.size();
  if (starts > 1) text += fmt::format("; {} starts", starts);
  if (starts > 0) text += fmt::format("; the first ended: {}", record.terminations[0].reason);
  return text;
}

/// The texts of the last call.
struct Texts {
  std::string chosen, why, ended;
};

void minimise(ricochet_problem* from, ricochet_minimisation& asked, Texts& texts) {
  require(from != nullptr, "the problem is NULL");
  require(asked.abi == RICOCHET_ABI,
          fmt::format("the minimisation is made for interface {}, this is {}", asked.abi,
                      RICOCHET_ABI));
  require(asked.point != nullptr, "point is NULL");
  require(asked.budget >= 1, fmt::format("budget {}: must be >= 1", asked.budget));
  require(asked.seed >= 0, fmt::format("seed {}: must be >= 0", asked.seed));
  require(asked.gradient_cost >= 0,
          fmt::format("gradient_cost {}: must be >= 0", asked.gradient_cost));
  static const auto& all = *new const std::vector<Solver>(all_solvers());
  const std::string wanted = asked.solver ? asked.solver : "auto";
  std::vector<std::string> names;
  for (const Solver& solver : all) names.push_back(solver.name);
  const std::string* const found = match(wanted, names);
  // What it throws says what may have been meant, or what this build lacks.
  const Solver solver =
      found ? all[static_cast<std::size_t>(found - names.data())] : solver_named(wanted);
  texts.chosen = solver.name;

  CallersProblem callers(*from);
  callers.problem().jumps = asked.jumps != 0;
  if (callers.problem().residuals || !solver.accepts(callers.problem())) {
    callers.score_by_last_values();
  }
  const Problem problem = accepted_formulation(callers.problem(), solver);
  Budget budget{asked.budget};
  if (asked.gradient_cost > 0) budget.gradient_price = asked.gradient_cost;
  if (solver.chooses) {
    if (const auto choice = choice_of(Evaluator(problem, budget), all)) {
      texts.chosen = choice->solver;
      texts.why = fmt::format("{}: {}", choice->line->declared, choice->line->reason);
    }
  }
  const RunRecord record = run(problem, callers.asking(solver), budget, asked.seed);
  texts.ended = one_line(ending_of(record));
  asked.evaluations = record.ledger.charged;
  asked.failed = callers.failed();
  asked.seconds = record.ledger.seconds;
  if (record.trace.empty()) {
    require(record.failure.empty() || record.termination_reason == TerminationReason::failure,
            texts.ended);  // the solver threw it
    return;
  }
  const Improvement& best = record.trace.back();
  Eigen::Map<Vector>(asked.point, problem.dimension()) = best.x;
  asked.objective = best.true_values.objective;
  asked.violation = best.true_values.violation;
}

}  // namespace

}  // namespace ricochet::interface

extern "C" __attribute__((visibility("default"))) std::int32_t ricochet_minimise(
    ricochet_problem* problem, ricochet_minimisation* minimisation) {
  using namespace ricochet::interface;
  const ricochet::DefaultFloatingPoint ours;
  if (!minimisation) return 1;
  Texts texts;
  std::int32_t code = 0;
  minimisation->objective = minimisation->violation = missing;
  minimisation->evaluations = minimisation->failed = 0;
  minimisation->seconds = 0;
  if (problem && minimisation->point) {
    for (std::int32_t i = 0; i < problem->dimension; ++i) minimisation->point[i] = missing;
  }
  try {
    minimise(problem, *minimisation, texts);
  } catch (const std::exception& error) {
    texts.ended = ricochet::one_line(error.what());
    code = 1;
  } catch (...) {
    texts.ended = "an exception that is not a std::exception";
    code = 1;
  }
  thread_local Texts last;  // a function may have called this one
  last = std::move(texts);
  minimisation->chosen = last.chosen.c_str();
  minimisation->why = last.why.c_str();
  minimisation->ended = last.ended.c_str();
  return code;
}
