#pragma once

#include <ricochet/ricochet.h>

#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "ricochet/evaluator.h"
#include "ricochet/random.h"

namespace ricochet::interface {

/// The C interface of an evaluator's problem. Its user sees the problem only through the evaluator
/// and draws from `random`; both must outlive it, and it must not be moved.
///
/// The pointers that are not null select what is requested: separate calls for objective and
/// constraints of one point are charged once.
///
/// Its functions throw nothing. If one fails, because the run is over or memory is exhausted, it
/// returns 1 (residual_count() 0) and writes nothing.
class SeenProblem : public ricochet_problem {
 public:
  SeenProblem(Evaluator& evaluator, const Vector& start, Random& random);
  SeenProblem(const SeenProblem&) = delete;
  SeenProblem& operator=(const SeenProblem&) = delete;

  /// The exception that one of the functions caught, or null; exceptions of the problem are the
  /// evaluator's failure instead.
  std::exception_ptr failure() const { return failure_; }

  /// From now on the calls of other threads fail; uniform() returns NaN to them.
  void answer_this_thread_only() { thread_ = std::this_thread::get_id(); }
  bool was_asked_by_others() const { return asked_by_others_; }

 protected:
  static std::int32_t values_at(ricochet_problem* problem, const double* x, double* objective,
                                double* constraints);
  static std::int32_t derivatives_at(ricochet_problem* problem, const double* x, double* objective,
                                     double* constraints, double* gradient, double* jacobian);
  static std::int32_t count_residuals_at(ricochet_problem* problem, const double* x);
  static std::int32_t residuals_at(ricochet_problem* problem, const double* x, double* residuals,
                                   double* jacobian);
  static std::int64_t evaluations_left(ricochet_problem* problem);
  static double next_uniform(ricochet_problem* problem);

 private:
  /// Returns the result of `ask` at x, or nothing.
  template <class Ask>
  auto told(const double* x, Ask ask) -> decltype(ask(Vector()));

  bool is_answered_here();
  void keep_count(Eigen::Index count) { count_ = static_cast<std::int32_t>(count); }

  Evaluator& evaluator_;
  Random& random_;
  Vector lower_, upper_, start_;  // copies: a solver may write into them
  Vector point_;                  // the last one, kept so that no call allocates another
  std::int32_t count_ = 0;        // of residuals, once known
  std::exception_ptr failure_;
  std::optional<std::thread::id> thread_;  // the only one that is answered; empty: all are
  std::atomic<bool> asked_by_others_ = false;
};

}  // namespace ricochet::interface
