#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "src/core/problem.h"
#include "src/core/stopwatch.h"

namespace ricochet {

/// What a run may spend. Seconds are of processor time in the run's own thread.
struct Budget {
  std::int64_t evaluations = 1000;
  double seconds = std::numeric_limits<double>::infinity();
  /// What a gradient is charged beside the value, in evaluations, >= 0; nothing: n. Jacobians come
  /// with it, and a Hessian is charged (n + 1) / 2 times as much.
  std::optional<std::int64_t> gradient_price = {};
};

/// Why the evaluator refuses.
enum class Refusal {
  none,         ///< it does not: the run may go on
  evaluations,  ///< the evaluations are spent
  seconds,      ///< the time is spent
  bad_point,    ///< the solver asked for a point that is not finite or has the wrong length
  failure,      ///< the problem threw; see Evaluator::failure
  paused,       ///< so many evaluations as were allowed for now are spent; see Evaluator::allow
};

/// What a call wants to know of a point; some solvers ask for one after the other.
enum class Part : unsigned {
  nothing = 0,  ///< yet: the point is paid for what will be asked next
  objective = 1,
  equalities = 2,
  inequalities = 4,
  everything = 7,
  jacobian = 8  ///< of the residuals, where they were asked for before as the objective
};

/// What was asked of the problem.
struct Ledger {
  std::int64_t values = 0;       ///< calls of evaluate
  std::int64_t derivatives = 0;  ///< calls of differentiate and residuals
  std::int64_t hessians = 0;     ///< calls of lagrangian_hessian
  /// Evaluations: 1 for values or residuals alone, 1 + n with their derivatives, n (n + 1) / 2 for
  /// a Hessian, unless the budget has another price of gradients.
  std::int64_t charged = 0;
  std::int64_t refused = 0;  ///< calls that were refused
  double seconds = 0;        ///< processor time of the run, scoring left out
};

/// A point that was truly better than all before it.
struct Improvement {
  std::int64_t evaluations;  ///< charged when it was found
  double seconds;
  Truth truth;
  Vector x;
};

/// The only one who counts, times, traces, and refuses when the budget is spent. Remembers the last
/// point, so that a solver that asks separately for objective, constraints and gradient at one
/// point pays once; who asks for the same of the same point again pays again. Every point is scored
/// by its truth off the clock: the trace, never a solver's answer, tells what was reached; where
/// the truth, or the objective that the solver was told, is no number, no point was reached. Points
/// outside the box are evaluated at their projection onto it.
///
/// Nothing throws through a solver's frame: an exception of the problem is stored in `failure`, and
/// from then on every call is refused.
class Evaluator {
 public:
  /// `on_improvement`, where there is one, is told at once of every point of the trace, off the
  /// clock.
  Evaluator(const Problem& problem, const Budget& budget,
            std::function<void(const Improvement&)> on_improvement = nullptr);

  const Problem& problem() const { return problem_; }

  /// Objective and constraints, equalities first, at x (length n), or nothing once the run is over.
  /// All are there, whichever part is asked for.
  std::optional<Values> values(const Vector& x, Part part = Part::everything);

  /// values(x, Part::objective)->objective.
  std::optional<double> objective(const Vector& x);

  /// Values and first derivatives at x, or nothing once the run is over. The problem must have
  /// them.
  std::optional<Derivatives> derivatives(const Vector& x, Part part = Part::everything);

  /// Residuals and their first derivatives at x, or nothing once the run is over. The problem must
  /// have them. What is known of x otherwise makes them no cheaper: they may be of another
  /// function.
  std::optional<Residuals> residuals(const Vector& x, Part part = Part::everything);

  /// Residuals alone, charged 1; who then asks for residuals(x) is charged n for their derivatives.
  std::optional<Vector> residual_values(const Vector& x, Part part = Part::objective);

  /// Problem::lagrangian_hessian at x, or nothing once the run is over; the problem must have it.
  /// Charged n (n + 1) / 2, as long as a gradient is charged n, and never less than 1. With value
  /// and gradient, 3, 21, 45 and 153 charged for 1, 5, 8 and 16 variables, a Hessian of the
  /// surrogates took as long as 3 to 4, 25, 28 and 95 values, measured.
  std::optional<Matrix> lagrangian_hessian(const Vector& x, double objective_factor,
                                           const Vector& multipliers);

  /// Shows the problem at this smoothing width, >= 0, from here on; it is judged as before. The
  /// problem must have the knob.
  void smooth(double width);

  /// The best point as shown since the start, or since the last call of smooth: all that a solver
  /// may know. Nothing before the first evaluation.
  const Vector* best_shown() const { return best_shown_ ? &best_shown_->x : nullptr; }

  /// Refuses, as if the budget were spent, after so many evaluations more; the next call begins
  /// anew. For solvers that put another solver to work several times.
  void allow(std::int64_t evaluations);

  /// Evaluations left before the evaluator refuses.
  std::int64_t remaining() const;

  /// The best point so far in truth, or nothing before the first evaluation.
  const Improvement* best() const { return trace_.empty() ? nullptr : &trace_.back(); }

  bool over() const { return refusal_ != Refusal::none; }
  Refusal refusal() const { return refusal_; }
  std::exception_ptr failure() const { return failure_; }
  Ledger ledger();
  const std::vector<Improvement>& trace() const { return trace_; }

 private:
  /// What one kind of call has told of the remembered point, and which parts were asked for.
  template <class Told>
  struct Memory {
    std::optional<Told> told;
    unsigned asked = 0;

    /// Whether the part is there and was not asked for before; from now on it was.
    bool has(Part part);
  };

  struct Shown {
    Truth taken_for;
    Vector x;
  };

  std::int64_t gradient_price() const;
  bool admits(const Vector& x, std::int64_t price);
  bool remembers(const Vector& x) const { return has_point_ && point_ == x; }
  void move_to(const Vector& x);
  void forget();
  void look(const Vector& x, const Values& values);
  void score(const Vector& x, const Values* known);
  const Problem& shown() const { return smoothed_ ? *smoothed_ : problem_; }

  template <class Work>
  bool guarded(Work work);

  bool ask_residuals(const Vector& x, Part part, std::int64_t price);

  const Problem& problem_;
  std::optional<Problem> smoothed_;
  std::optional<Shown> best_shown_;
  Budget budget_;
  std::function<void(const Improvement&)> on_improvement_;
  std::int64_t pause_ = std::numeric_limits<std::int64_t>::max();  // evaluations, charged till then
  Ledger ledger_;
  Refusal refusal_ = Refusal::none;
  std::exception_ptr failure_;
  std::vector<Improvement> trace_;
  Stopwatch stopwatch_;
  bool has_point_ = false;
  Vector point_;   // remembered, as asked for
  Vector inside_;  // its projection onto the box
  Memory<Values> values_;
  Memory<Derivatives> derivatives_;
  Memory<Residuals> residuals_;
  bool paid_jacobian_ = false;  // of the residuals
};

}  // namespace ricochet
