#include "src/core/evaluator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/core/processor_time.h"

namespace ricochet {

Evaluator::Evaluator(const Problem& problem, const Budget& budget)
    : problem_(problem), budget_(budget), started_(processor_seconds()) {}

std::int64_t Evaluator::remaining() const {
  return over() ? 0 : std::min(budget_.evaluations, pause_) - ledger_.charged;
}

void Evaluator::allow(std::int64_t evaluations) {
  pause_ = ledger_.charged + evaluations;
  if (refusal_ == Refusal::paused) refusal_ = Refusal::none;
}

bool Evaluator::admits(const Vector& x, std::int64_t price) {
  if (!over()) {
    ledger_.seconds = processor_seconds() - started_;
    if (ledger_.charged + price > pause_) refusal_ = Refusal::paused;
    if (ledger_.charged + price > budget_.evaluations) refusal_ = Refusal::evaluations;
    if (ledger_.seconds >= budget_.seconds) refusal_ = Refusal::seconds;
    if (x.size() != problem_.dimension() || !x.allFinite()) refusal_ = Refusal::bad_point;
  }
  if (over()) ++ledger_.refused;
  return !over();
}

template <class Work>
bool Evaluator::guarded(Work work) {
  try {
    work();
    return true;
  } catch (...) {
    failure_ = std::current_exception();
    refusal_ = Refusal::failure;
    return false;
  }
}

void Evaluator::charge(std::int64_t price) {
  ledger_.charged += price;
  ledger_.seconds = processor_seconds() - started_;
}

void Evaluator::look(const Vector& x, const Values& values) {
  const Truth taken_for = truth_of(values, problem_.equalities);
  if (!best_shown_ || better(taken_for, best_shown_->taken_for)) best_shown_ = {taken_for, x};
}

void Evaluator::smooth(double width) {
  if (!problem_.smoothed) throw std::logic_error(problem_.name + " has no smoothing width");
  smoothed_ = problem_.smoothed(width);
  best_shown_.reset();
  values_.reset();
  derivatives_.reset();
  residuals_.reset();
}

/// `known`: the values at x, or null where nobody has asked for them.
void Evaluator::score(const Vector& x, const Values* known) {
  const double before = processor_seconds();
  const Truth truth = problem_.truth        ? problem_.truth(x)
                      : known && !smoothed_ ? truth_of(*known, problem_.equalities)
                                            : truth_of(problem_.evaluate(x), problem_.equalities);
  const bool is_number = !std::isnan(truth.objective) && !std::isnan(truth.violation);
  if (is_number && (trace_.empty() || better(truth, trace_.back().truth))) {
    trace_.push_back({ledger_.charged, ledger_.seconds, truth, x});
  }
  started_ += processor_seconds() - before;
}

std::optional<Values> Evaluator::values(const Vector& x) {
  if (!over() && values_ && values_point_ == x) return values_;
  if (!admits(x, 1)) return std::nullopt;
  const Vector inside = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  const bool done = guarded([&] {
    values_ = shown().evaluate(inside);
    values_point_ = x;
    ++ledger_.values;
    charge(1);
    look(inside, *values_);
    score(inside, &*values_);
  });
  return done ? values_ : std::nullopt;
}

std::optional<double> Evaluator::objective(const Vector& x) {
  const auto result = values(x);
  return result ? std::optional(result->objective) : std::nullopt;
}

std::optional<Derivatives> Evaluator::derivatives(const Vector& x) {
  if (!over() && derivatives_ && derivatives_point_ == x) return derivatives_;
  const bool known = values_ && values_point_ == x;
  const std::int64_t price = problem_.dimension() + (known ? 0 : 1);
  if (!admits(x, price)) return std::nullopt;
  const Vector inside = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  const bool done = guarded([&] {
    if (!shown().differentiate) throw std::logic_error(problem_.name + " has no derivatives");
    derivatives_ = shown().differentiate(inside);
    derivatives_point_ = x;
    values_ = derivatives_->values;
    values_point_ = x;
    ++ledger_.derivatives;
    charge(price);
    look(inside, *values_);
    score(inside, &*values_);
  });
  return done ? derivatives_ : std::nullopt;
}

std::optional<Residuals> Evaluator::residuals(const Vector& x) {
  if (!over() && residuals_ && residuals_point_ == x) return residuals_;
  const std::int64_t price = 1 + problem_.dimension();
  if (!admits(x, price)) return std::nullopt;
  const Vector inside = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  const bool done = guarded([&] {
    if (!shown().residuals) throw std::logic_error(problem_.name + " has no residuals");
    residuals_ = shown().residuals(inside);
    residuals_point_ = x;
    const Eigen::Index count = residuals_->values.size();
    if (count == 0 || residuals_->jacobian.rows() != count ||
        residuals_->jacobian.cols() != x.size()) {
      throw std::logic_error(problem_.name + " has no residuals, or a jacobian that does not fit");
    }
    ++ledger_.derivatives;
    charge(price);
    score(inside, values_ && values_point_ == x ? &*values_ : nullptr);
  });
  return done ? residuals_ : std::nullopt;
}

}  // namespace ricochet
