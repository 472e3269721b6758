#pragma once

#include <cstdint>
#include <mutex>
#include <utility>

#include "ricochet/evaluator.h"
#include "ricochet/random.h"
#include "src/interface/seen_problem.h"

namespace ricochet::interface {

/// A problem, and the run that evaluates it.
struct OpenedRun {
  OpenedRun(Problem asked, std::int64_t budget, std::uint64_t seed)
      : problem(std::move(asked)), evaluator(problem, Budget{budget}), random(seed) {}

  Problem problem;
  Evaluator evaluator;
  Random random;
};

/// A problem opened by an external program. After every refused call, last_error() gives the
/// reason. Several threads may call its functions at once: they take turns.
class OpenedProblem : private OpenedRun, public SeenProblem {
 public:
  /// `budget`: evaluations; `seed`: for uniform().
  OpenedProblem(Problem asked, std::int64_t budget, std::uint64_t seed);

  /// The true objective and violation of x, or of its projection onto the box; not charged. Throws
  /// std::invalid_argument for null or a point that is not finite, and what the problem throws.
  TrueValues judge(const double* x) const;

  /// In its formulation and instance.
  const Problem& stated() const { return problem; }

 private:
  /// The function of SeenProblem of this signature, in turn; where it returns `refused` it keeps
  /// the reason as the last error.
  template <auto function, auto refused>
  struct InTurn;

  /// Why the last call was refused.
  std::exception_ptr reason() const;

  std::int64_t budget_;
  mutable std::mutex mutex_;
};

}  // namespace ricochet::interface
