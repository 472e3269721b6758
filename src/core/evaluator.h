#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"

namespace ricochet {

/// Scores the points of a run on the true objective and keeps the improvements. The run holds it;
/// a solver does not see it.
class Scorer {
 public:
  /// `problem` must outlive it. `on_improvement`, if not empty, is called at once for every
  /// improvement; its time is not counted.
  explicit Scorer(const Problem& problem,
                  std::function<void(const Improvement&)> on_improvement = nullptr);

  /// Scores a point of the box, of length n. `known`: the problem's values there, or null.
  /// `evaluations`: charged so far. The time of scoring is not counted. A true objective or
  /// violation that is NaN is no improvement. Throws what the problem throws.
  void score(const Vector& x, const Values* known, std::int64_t evaluations, Stopwatch& clock);

  const std::vector<Improvement>& trace() const { return trace_; }

  /// The best point so far, or null.
  const Improvement* best() const { return trace_.empty() ? nullptr : &trace_.back(); }

 private:
  const Problem& problem_;
  std::function<void(const Improvement&)> on_improvement_;
  std::vector<Improvement> trace_;
};

/// The problem without constraints, for solvers that take none: the objective plus `weight` > 0
/// times the sum of the violations (of an equality its absolute value). This is the exact l1
/// penalty (Nocedal and Wright, Numerical Optimization, section 17.2). The name stays the same, and
/// so do the true objective and true violation on which it is scored. Its derivatives, if any, are
/// one-sided at the kinks. It has no residuals: it is no sum of squares.
Problem penalised(const Problem& problem, double weight);

}  // namespace ricochet
