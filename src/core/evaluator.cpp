#include "src/core/evaluator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ricochet/evaluator.h"

namespace ricochet {

Evaluator::Evaluator(const Problem& problem, const Budget& budget, Scorer* scorer)
    : problem_(problem), scorer_(scorer), budget_(budget) {}

std::int64_t Evaluator::remaining() const {
  return over() ? 0 : std::min(budget_.evaluations, pause_) - ledger_.charged;
}

void Evaluator::allow(std::int64_t evaluations) {
  pause_ = ledger_.charged + evaluations;
  if (termination_reason_ == TerminationReason::paused)
    termination_reason_ = TerminationReason::none;
}

Ledger Evaluator::ledger() {
  ledger_.seconds = stopwatch_.read();
  return ledger_;
}

std::int64_t Evaluator::gradient_price() const {
  return budget_.gradient_price.value_or(problem_.dimension());
}

bool Evaluator::admits(const Vector& x, std::int64_t price) {
  if (!over()) {
    if (ledger_.charged + price > pause_) termination_reason_ = TerminationReason::paused;
    if (ledger_.charged + price > budget_.evaluations)
      termination_reason_ = TerminationReason::evaluations;
    if (std::isfinite(budget_.seconds) && stopwatch_.glance() >= budget_.seconds) {
      termination_reason_ = TerminationReason::seconds;
    }
    if (x.size() != problem_.dimension() || !x.allFinite())
      termination_reason_ = TerminationReason::bad_point;
  }
  if (over()) ++ledger_.refused;
  return !over();
}

template <class Told>
bool Evaluator::Memory<Told>::has(Part part) {
  const auto parts = static_cast<unsigned>(part);
  if (!told || (asked & parts) != 0) return false;
  asked |= parts;
  return true;
}

void Evaluator::forget() {
  has_point_ = false;
  values_ = {};
  derivatives_ = {};
  residuals_ = {};
}

/// Makes x the remembered point; forgets all values if it is another one.
void Evaluator::move_to(const Vector& x) {
  if (remembers(x)) return;
  forget();
  point_ = x;
  inside_ = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  has_point_ = true;
}

template <class Work>
bool Evaluator::guarded(Work work) {
  try {
    work();
    return true;
  } catch (...) {
    failure_ = std::current_exception();
    termination_reason_ = TerminationReason::failure;
    return false;
  }
}

void Evaluator::look(const Vector& x, const Values& values) {
  const TrueValues taken_for = true_values_of(values, problem_.equalities);
  if (!best_shown_ || better(taken_for, best_shown_->taken_for)) best_shown_ = {taken_for, x};
}

void Evaluator::smooth(double smoothing) {
  if (!problem_.smoothed) throw std::logic_error(problem_.name + " has no smoothing parameter");
  smoothed_ = problem_.smoothed(smoothing);
  best_shown_.reset();
  forget();
}

/// Scores the remembered point, unless the solver received NaN as its objective.
void Evaluator::score() {
  const Values* told = values_.told ? &*values_.told : nullptr;
  if (!scorer_ || (told && std::isnan(told->objective))) return;
  scorer_->score(inside_, smoothed_ ? nullptr : told, ledger_.charged, stopwatch_);
}

std::optional<Values> Evaluator::values(const Vector& x, Part part) {
  if (!over() && remembers(x) && values_.has(part)) return values_.told;
  if (!admits(x, 1)) return std::nullopt;
  const bool done = guarded([&] {
    if (values_.told) forget();
    move_to(x);
    values_ = {shown().evaluate(inside_), static_cast<unsigned>(part)};
    ++ledger_.values;
    ++ledger_.charged;
    look(inside_, *values_.told);
    score();
  });
  return done ? values_.told : std::nullopt;
}

std::optional<double> Evaluator::objective(const Vector& x) {
  const auto result = values(x, Part::objective);
  return result ? std::optional(result->objective) : std::nullopt;
}

std::optional<Derivatives> Evaluator::derivatives(const Vector& x, Part part) {
  if (!over() && remembers(x) && derivatives_.has(part)) return derivatives_.told;
  const bool again = remembers(x) && derivatives_.told;
  const bool known = remembers(x) && values_.told && !again;
  const std::int64_t price = gradient_price() + (known ? 0 : 1);
  if (!admits(x, price)) return std::nullopt;
  const bool done = guarded([&] {
    if (!shown().differentiate) throw std::logic_error(problem_.name + " has no derivatives");
    if (again) forget();
    move_to(x);
    derivatives_ = {shown().differentiate(inside_), static_cast<unsigned>(part)};
    values_.told = derivatives_.told->values;
    ++ledger_.derivatives;
    ledger_.charged += price;
    look(inside_, *values_.told);
    score();
  });
  return done ? derivatives_.told : std::nullopt;
}

std::optional<Matrix> Evaluator::lagrangian_hessian(const Vector& x, double objective_factor,
                                                    const Vector& multipliers) {
  const Eigen::Index n = problem_.dimension();
  const std::int64_t price = std::max<std::int64_t>(1, gradient_price() * (n + 1) / 2);
  if (!admits(x, price)) return std::nullopt;
  std::optional<Matrix> hessian;
  const bool done = guarded([&] {
    if (!shown().lagrangian_hessian) {
      throw std::logic_error(problem_.name + " has no second derivatives");
    }
    move_to(x);
    hessian = shown().lagrangian_hessian(inside_, objective_factor, multipliers);
    if (hessian->rows() != n || hessian->cols() != n) {
      throw std::logic_error(problem_.name + " has a Hessian that does not fit");
    }
    ++ledger_.hessians;
    ledger_.charged += price;
    score();
  });
  return done ? hessian : std::nullopt;
}

bool Evaluator::ask_residuals(const Vector& x, Part part, std::int64_t price, bool derivatives) {
  if (!admits(x, price)) return false;
  return guarded([&] {
    if (!shown().residuals) throw std::logic_error(problem_.name + " has no residuals");
    move_to(x);
    const bool alone = !derivatives && shown().residual_values;
    residuals_ = {
        alone ? Residuals{shown().residual_values(inside_), {}} : shown().residuals(inside_),
        static_cast<unsigned>(part)};
    const Residuals& told = *residuals_.told;
    const Eigen::Index count = told.values.size();
    const bool fits = alone || (told.jacobian.rows() == count && told.jacobian.cols() == x.size());
    if (count == 0 || !fits) {
      throw std::logic_error(problem_.name + " has no residuals, or a jacobian that does not fit");
    }
    ++ledger_.derivatives;
    ledger_.charged += price;
    score();
  });
}

std::optional<Vector> Evaluator::residual_values(const Vector& x, Part part) {
  if (!over() && remembers(x) && residuals_.has(part)) return residuals_.told->values;
  if (!ask_residuals(x, part, 1, false)) return std::nullopt;
  paid_jacobian_ = false;
  return residuals_.told->values;
}

std::optional<Residuals> Evaluator::residuals(const Vector& x, Part part) {
  const bool told = !over() && remembers(x) && residuals_.told;
  if (told && paid_jacobian_ && residuals_.has(part)) return residuals_.told;
  if (told && !paid_jacobian_ && residuals_.told->jacobian.size() > 0) {
    if (!admits(x, gradient_price())) return std::nullopt;
    ledger_.charged += gradient_price();
    residuals_.asked |= static_cast<unsigned>(part);
  } else if (!ask_residuals(x, part, gradient_price() + (told && !paid_jacobian_ ? 0 : 1), true)) {
    return std::nullopt;
  }
  paid_jacobian_ = true;
  return residuals_.told;
}

Scorer::Scorer(const Problem& problem, std::function<void(const Improvement&)> on_improvement)
    : problem_(problem), on_improvement_(std::move(on_improvement)) {}

void Scorer::score(const Vector& x, const Values* known, std::int64_t evaluations,
                   Stopwatch& clock) {
  TrueValues true_values;
  if (known && !problem_.true_values) {
    true_values = true_values_of(*known, problem_.equalities);
  } else {
    clock.leave_out([&] { true_values = true_values_at(problem_, x); });
  }
  if (std::isnan(true_values.objective) || std::isnan(true_values.violation)) return;
  if (best() && !better(true_values, best()->true_values)) return;
  trace_.push_back({evaluations, clock.read(), true_values, x});
  if (on_improvement_) clock.leave_out([&] { on_improvement_(trace_.back()); });
}

namespace {

/// The violations of the constraints, with their sign.
Vector broken(const Vector& constraints, Eigen::Index equalities) {
  Vector result = constraints;
  const Eigen::Index inequalities = result.size() - equalities;
  result.tail(inequalities) = result.tail(inequalities).cwiseMax(0);
  return result;
}

}  // namespace

Problem penalised(const Problem& problem, double weight) {
  Problem result = problem;
  result.constraints = result.equalities = 0;
  const auto penalise = [weight, m = problem.equalities](const Values& values) {
    return Values{values.objective + weight * broken(values.constraints, m).lpNorm<1>(), {}};
  };
  result.evaluate = [evaluate = problem.evaluate, penalise](const Vector& x) {
    return penalise(evaluate(x));
  };
  if (problem.differentiate) {
    result.differentiate = [differentiate = problem.differentiate, penalise, weight,
                            m = problem.equalities](const Vector& x) {
      const Derivatives d = differentiate(x);
      const Vector sides = broken(d.values.constraints, m).cwiseSign();
      return Derivatives{penalise(d.values), d.gradient + weight * d.jacobian.transpose() * sides,
                         Matrix(0, d.gradient.size()), d.trust};
    };
  }
  if (problem.lagrangian_hessian) {
    result.lagrangian_hessian = [hessian = problem.lagrangian_hessian, evaluate = problem.evaluate,
                                 weight, m = problem.equalities](
                                    const Vector& x, double objective_factor, const Vector&) {
      const Vector sides = broken(evaluate(x).constraints, m).cwiseSign();
      return hessian(x, objective_factor, objective_factor * weight * sides);
    };
  }
  result.residuals = nullptr;
  result.residual_values = nullptr;
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, weight](double smoothing) {
      return penalised(smoothed(smoothing), weight);
    };
  }
  if (!problem.true_values) {
    result.true_values = [evaluate = problem.evaluate, m = problem.equalities](const Vector& x) {
      return true_values_of(evaluate(x), m);
    };
  }
  return result;
}

}  // namespace ricochet
