#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ricochet/capabilities.h"
#include "ricochet/evaluator.h"
#include "ricochet/random.h"

namespace ricochet {

/// What a solver returns when it ends. It is not trusted: the suite scores the points itself.
struct SolverTermination {
  std::string reason;  ///< readable text
  /// The returned point, of length n; if empty, the best one that it evaluated.
  std::optional<Vector> point = {};

  bool operator==(const SolverTermination&) const = default;
};

/// What a solver returns once the evaluator refuses.
enum class AtLimit {
  best_evaluated,  ///< the best point that it evaluated
  own_point        ///< what its library returns at the largest limit of its own, of evaluations or
                   ///< iterations, that the budget allows; the best evaluated one if it allows none
};

/// A solver of box-bounded minimisation problems.
struct Solver {
  std::string name;  ///< e.g. "nlopt-cobyla"
  /// Of the library behind it. Where an adapter returns other points than before, it says so here,
  /// as "(adapter 2)": stored runs are taken over only if their solver has the same version.
  std::string version;
  bool stochastic = false;
  Capabilities capabilities = {};
  AtLimit at_limit = AtLimit::best_evaluated;

  /// Minimises from `start`, a point of the box, until it is done or the evaluator refuses. A run
  /// restarts it elsewhere while budget is left. `random` is its only source of randomness. It may
  /// be called from several threads at once.
  std::function<SolverTermination(Evaluator&, const Vector& start, Random& random)> solve;

  /// Hash of the files that a user's solver consists of, when it was loaded; empty: of the suite.
  std::string content = {};
  /// Returns the file of a user's solver that is another one now; "" if there is none.
  std::function<std::string()> changed_file = {};

  /// Returns true if the solver can run on the problem.
  bool accepts(const Problem& problem) const { return capabilities.accept(problem); }
};

}  // namespace ricochet
