#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>

#include "ricochet/problem.h"

namespace ricochet {

/// Processor time of one run, in its own thread, since construction. A reading takes as long as a
/// dozen cheap evaluations; glance() is for calls at every evaluation.
class Stopwatch {
 public:
  Stopwatch();

  /// [s], exact, without excluded work.
  double read();

  /// [s], of the last reading: about 0.1 ms old if glances are evenly spaced, and at most 64
  /// glances old.
  double glance();

  /// Does work whose time is not counted.
  template <class Work>
  void leave_out(Work work) {
    const double before = now();
    work();
    started_ += now() - before;
  }

 private:
  static double now();

  double started_;  // moved forward by excluded work
  double last_ = 0;
  std::int64_t glances_ = 0;  // since the last reading
  std::int64_t until_ = 1;    // glances from one reading to the next
};

/// The budget of a run.
struct Budget {
  std::int64_t evaluations = 1000;
  double seconds = std::numeric_limits<double>::infinity();  ///< processor time of the run's thread
  /// Charge for a gradient beside the value, in evaluations, >= 0; n if empty. The Jacobian is
  /// included; a Hessian is charged (n + 1) / 2 times as much.
  std::optional<std::int64_t> gradient_price = {};
};

/// Why the evaluator refuses calls.
enum class TerminationReason {
  none,         ///< no refusal: the run may go on
  evaluations,  ///< the evaluations are spent
  seconds,      ///< the time is spent
  bad_point,    ///< the solver requested a point that is not finite or not of length n
  failure,      ///< the problem threw; see Evaluator::failure
  paused,       ///< the evaluations that Evaluator::allow granted are spent
};

/// The part of a point's values that a call requests; some solvers request them one after another.
enum class Part : unsigned {
  nothing = 0,  ///< none yet: the point is charged, the next call for it is free
  objective = 1,
  equalities = 2,
  inequalities = 4,
  everything = 7,
  jacobian = 8  ///< of the residuals, whose values were requested before as the objective
};

/// What a run has requested from the problem.
struct Ledger {
  std::int64_t values = 0;       ///< calls of evaluate
  std::int64_t derivatives = 0;  ///< calls of differentiate and residuals
  std::int64_t hessians = 0;     ///< calls of lagrangian_hessian
  /// Evaluations: 1 for values or residuals alone, 1 + n with their derivatives, n (n + 1) / 2 for
  /// a Hessian, unless the budget sets another gradient price.
  std::int64_t charged = 0;
  std::int64_t refused = 0;  ///< refused calls
  double seconds = 0;        ///< processor time of the run without scoring
};

class Scorer;

/// A solver's access to a problem: its box, which derivatives it has, the remaining budget and the
/// values at requested points. It counts, times and refuses calls; it shows neither the true
/// objective nor the best known point.
///
/// It remembers the last point: separate calls for objective, constraints and gradient of one point
/// are charged once. Repeated evaluations of a point count against the budget. Points outside the
/// box are evaluated at their projection onto it.
///
/// No exception passes through a solver: an exception of the problem is stored in `failure`, and
/// from then on every call is refused.
class Evaluator {
 public:
  /// `scorer`, if not null, scores every point at which the solver receives a number; its time is
  /// not counted. Problem and scorer must outlive the evaluator.
  Evaluator(const Problem& problem, const Budget& budget, Scorer* scorer = nullptr);
  // A copy would have a separate budget.
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  const std::string& name() const { return problem_.name; }
  Eigen::Index dimension() const { return problem_.dimension(); }
  const Vector& lower() const { return problem_.lower; }  ///< length n
  const Vector& upper() const { return problem_.upper; }  ///< length n
  Eigen::Index constraints() const { return problem_.constraints; }
  Eigen::Index equalities() const { return problem_.equalities; }  ///< the first of the constraints
  bool has_derivatives() const { return static_cast<bool>(problem_.differentiate); }
  bool has_hessian() const { return static_cast<bool>(problem_.lagrangian_hessian); }
  bool has_residuals() const { return static_cast<bool>(problem_.residuals); }
  bool has_smoothing() const { return static_cast<bool>(problem_.smoothed); }
  bool jumps() const { return problem_.jumps; }  ///< see Problem::jumps
  const Budget& budget() const { return budget_; }
  std::int64_t gradient_price() const;  ///< what a gradient is charged beside the value

  /// Objective and constraints, equalities first, at x (length n), or nothing once the run is over.
  /// Charged 1. The result is complete, whatever `part` is.
  std::optional<Values> values(const Vector& x, Part part = Part::everything);

  /// values(x, Part::objective)->objective.
  std::optional<double> objective(const Vector& x);

  /// Values and first derivatives at x, or nothing once the run is over. Charged 1 + n, or n if the
  /// call before requested the values at x. A problem without derivatives ends the run as a
  /// failure, and so does one without requested residuals or Hessians.
  std::optional<Derivatives> derivatives(const Vector& x, Part part = Part::everything);

  /// Residuals and their first derivatives at x, or nothing once the run is over. Charged 1 + n,
  /// even if the values at x are known: the residuals may belong to another function.
  std::optional<Residuals> residuals(const Vector& x, Part part = Part::everything);

  /// Residuals alone, charged 1; residuals(x) directly after it is charged n.
  std::optional<Vector> residual_values(const Vector& x, Part part = Part::objective);

  /// Problem::lagrangian_hessian at x, n x n, or nothing once the run is over. Charged
  /// n (n + 1) / 2 if a gradient is charged n, and never less than 1. Measured: value, gradient and
  /// Hessian of the surrogates take as long as 3 to 4, 25, 28 and 95 values for 1, 5, 8 and 16
  /// variables, and are charged 3, 21, 45 and 153.
  std::optional<Matrix> lagrangian_hessian(const Vector& x, double objective_factor,
                                           const Vector& multipliers);

  /// Presents the problem with this smoothing parameter >= 0 from now on; 0 means no smoothing. The
  /// score stays that of the true objective. Throws std::logic_error if the problem cannot be
  /// smoothed.
  void smooth(double smoothing);

  /// The point with the best values returned to the solver since the run began or since the last
  /// call of smooth(); null before the first evaluation.
  const Vector* best_shown() const { return best_shown_ ? &best_shown_->x : nullptr; }

  /// Refuses calls, as if the budget were spent, after this many further evaluations; the next call
  /// of allow() sets another limit. For solvers that run another solver several times.
  void allow(std::int64_t evaluations);

  /// Evaluations left before the evaluator refuses; 0 once the run is over.
  std::int64_t remaining() const;

  bool over() const {
    return termination_reason_ != TerminationReason::none;
  }  ///< every call is refused
  TerminationReason termination_reason() const { return termination_reason_; }
  std::exception_ptr failure() const {
    return failure_;
  }  ///< the exception of the problem, or null
  Ledger ledger();

 private:
  /// The result of one kind of call at the remembered point, and the parts requested so far.
  template <class Told>
  struct Memory {
    std::optional<Told> told;
    unsigned asked = 0;

    /// Returns true if the part is available and was not requested before; marks it as requested.
    bool has(Part part);
  };

  struct Shown {
    TrueValues taken_for;
    Vector x;
  };

  bool admits(const Vector& x, std::int64_t price);
  bool remembers(const Vector& x) const { return has_point_ && point_ == x; }
  void move_to(const Vector& x);
  void forget();
  void look(const Vector& x, const Values& values);
  void score();
  const Problem& shown() const { return smoothed_ ? *smoothed_ : problem_; }

  template <class Work>
  bool guarded(Work work);

  bool ask_residuals(const Vector& x, Part part, std::int64_t price, bool derivatives);

  const Problem& problem_;
  std::optional<Problem> smoothed_;
  std::optional<Shown> best_shown_;
  Scorer* scorer_;
  Budget budget_;
  std::int64_t pause_ = std::numeric_limits<std::int64_t>::max();  // in charged evaluations
  Ledger ledger_;
  TerminationReason termination_reason_ = TerminationReason::none;
  std::exception_ptr failure_;
  Stopwatch stopwatch_;
  bool has_point_ = false;
  Vector point_;   // remembered, as requested
  Vector inside_;  // its projection onto the box
  Memory<Values> values_;
  Memory<Derivatives> derivatives_;
  Memory<Residuals> residuals_;
  bool paid_jacobian_ = false;  // of the residuals
};

/// A point whose true objective was better than that of every earlier one.
struct Improvement {
  std::int64_t evaluations;  ///< charged up to its evaluation
  double seconds;
  TrueValues true_values;
  Vector x;
};

// @file
// A limit of the time that a computation may take.

/// The result that was asked for is not known when the time limit is reached.
class TimeLimitReached : public std::exception {
 public:
  const char* what() const noexcept override { return "the time limit is reached"; }
};

/// Limits the time of what is computed in this thread while the object lives, and in the threads
/// that share the work. When it is reached, simulate(), regimes_of() and quiet_speed() return what
/// they know by then, and how far it goes; all else that simulates throws TimeLimitReached. Results
/// that are there in time have the same bits as without a limit. Inside another limit, the one that
/// ends first holds.
class TimeLimit {
 public:
  /// `seconds`: of the wall clock, > 0; infinity: no limit.
  explicit TimeLimit(double seconds);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  /// Looks at the clock, unless it was reached before.
  bool is_reached();
  bool was_reached() const { return reached_.load(std::memory_order_relaxed); }

  /// What is computed now, such as "regimes", and the share of it that is done, in [0, 1]; nullptr
  /// before anything is reported. These may be called from other threads.
  const char* stage() const { return stage_.load(std::memory_order_relaxed); }
  double share() const { return share_.load(std::memory_order_relaxed); }
  void report(const char* stage, double share);

 private:
  std::chrono::steady_clock::time_point end_;
  TimeLimit* outer_;
  TimeLimit* outer_listener_;
  std::atomic<bool> reached_ = false;
  std::atomic<const char*> stage_ = nullptr;
  std::atomic<double> share_ = 0;
};

}  // namespace ricochet
