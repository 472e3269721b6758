#pragma once

#include <functional>
#include <optional>
#include <string>

#include "src/core/evaluator.h"
#include "src/core/random.h"

namespace ricochet {

/// What a solver says of its own end. Data, never the truth: the suite judges by itself.
struct SolverExit {
  std::string reason;
  /// The point that it hands over; without one the best that it was shown since it began.
  std::optional<Vector> point = {};

  bool operator==(const SolverExit&) const = default;
};

/// A solver of box-bounded minimisation problems.
struct Solver {
  std::string name;     ///< e.g. "nlopt-cobyla"
  std::string version;  ///< of the library behind it
  bool stochastic = false;

  /// Whether it can be put to work on this problem: dimension, constraints (equalities and
  /// others), derivatives.
  std::function<bool(const Problem&)> accepts;

  /// Minimises from `start` with what the evaluator grants. Returns when it is done or when the
  /// evaluator refuses; the harness restarts it elsewhere while budget is left. All randomness
  /// comes from `random`. May be called from several threads at once.
  std::function<SolverExit(Evaluator&, const Vector& start, Random& random)> solve;
};

}  // namespace ricochet
