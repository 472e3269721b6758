#pragma once

#include <cstdint>
#include <utility>

#include "src/core/evaluator.h"
#include "src/core/random.h"
#include "src/interface/seen_problem.h"

namespace ricochet::interface {

/// A problem, and the run that asks it.
struct OpenedRun {
  OpenedRun(Problem asked, std::int64_t budget, std::uint64_t seed)
      : problem(std::move(asked)), evaluator(problem, Budget{budget}), random(seed) {}

  Problem problem;
  Evaluator evaluator;
  Random random;
};

/// A problem that a program outside has opened. Whenever it refuses, last_error() says why.
class OpenedProblem : private OpenedRun, public SeenProblem {
 public:
  /// `budget`: evaluations; `seed`: of uniform().
  OpenedProblem(Problem asked, std::int64_t budget, std::uint64_t seed);

  /// What x, or its projection onto the box, is truly worth; costs nothing. Throws
  /// std::invalid_argument for null or a point that is not finite, and what the problem throws.
  Truth judge(const double* x) const;

 private:
  static std::int32_t values_or_reason(ricochet_problem* problem, const double* x,
                                       double* objective, double* constraints);
  static std::int32_t derivatives_or_reason(ricochet_problem* problem, const double* x,
                                            double* objective, double* constraints,
                                            double* gradient, double* jacobian);
  static std::int32_t residual_count_or_reason(ricochet_problem* problem, const double* x);
  static std::int32_t residuals_or_reason(ricochet_problem* problem, const double* x,
                                          double* residuals, double* jacobian);

  /// Why the last call was refused.
  std::exception_ptr reason() const;

  std::int64_t budget_;
};

}  // namespace ricochet::interface
