#pragma once

#include <ricochet/ricochet.h>

#include <exception>

#include "src/core/evaluator.h"
#include "src/core/random.h"

namespace ricochet::interface {

/// What an evaluator's problem looks like from C. Whoever is handed it sees the problem through the
/// evaluator alone, and draws from `random`; both must outlive it, and it stays where it is.
///
/// What is asked for is told by which pointers are not null: who asks for objective and constraints
/// of one point in two calls pays once.
///
/// Nothing is thrown through its functions. Where one cannot do what it is asked, because the run
/// is over or because no memory is left, they return 1, residual_count() 0, and write nothing.
class SeenProblem : public ricochet_problem {
 public:
  SeenProblem(Evaluator& evaluator, Random& random);
  SeenProblem(const SeenProblem&) = delete;
  SeenProblem& operator=(const SeenProblem&) = delete;

  Evaluator& evaluator() { return evaluator_; }

  /// What one of the functions would have thrown, or null; what the problem throws is the
  /// evaluator's failure instead.
  std::exception_ptr failure() const { return failure_; }

 protected:
  static std::int32_t values_at(ricochet_problem* problem, const double* x, double* objective,
                                double* constraints);
  static std::int32_t derivatives_at(ricochet_problem* problem, const double* x, double* objective,
                                     double* constraints, double* gradient, double* jacobian);
  static std::int32_t count_residuals_at(ricochet_problem* problem, const double* x);
  static std::int32_t residuals_at(ricochet_problem* problem, const double* x, double* residuals,
                                   double* jacobian);

 private:
  static std::int64_t evaluations_left(ricochet_problem* problem);
  static double next_uniform(ricochet_problem* problem);

  /// What `ask` tells of x, or nothing.
  template <class Ask>
  auto told(const double* x, Ask ask) -> decltype(ask(Vector()));

  void keep_count(Eigen::Index count) { count_ = static_cast<std::int32_t>(count); }

  Evaluator& evaluator_;
  Random& random_;
  Vector point_;            // asked for last: kept, so that no call allocates another
  std::int32_t count_ = 0;  // of the residuals, once it is known
  std::exception_ptr failure_;
};

}  // namespace ricochet::interface
