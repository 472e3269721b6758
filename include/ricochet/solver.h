#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/random.h"

namespace ricochet {

/// Which problems a solver can solve. A solver declares it once; accepts() decides by it, and
/// `list solvers` prints it.
struct Capabilities {
  enum class Constraints {
    none,          ///< bounds only
    inequalities,  ///< inequalities, no equalities
    all            ///< inequalities and equalities
  };

  enum class Order { value, gradient, hessian };

  static constexpr Eigen::Index any_number = std::numeric_limits<Eigen::Index>::max();

  Eigen::Index least_variables = 1;
  Eigen::Index most_variables = any_number;
  Constraints constraints = Constraints::none;
  bool needs_constraints = false;    ///< at least one of the constraints that it takes
  Order derivatives = Order::value;  ///< the highest order needed; a Hessian is that of the
                                     ///< Lagrangian and comes with the gradient
  bool needs_residuals = false;
  bool needs_smoothing = false;  ///< it needs Problem::smoothed

  /// Returns true if the solver can run on the problem. No solver takes a box of a single point.
  bool accept(const Problem& problem) const;

  /// "any number", "1", "2 or more", "up to 8" or "2 to 8".
  std::string variables_in_words() const;
  /// "none", "inequalities", "all", "needs inequalities", or "needs some" (of any kind).
  std::string constraints_in_words() const;
  /// "nothing", or those of "gradients", "Hessians", "residuals" and "smoothing" that the problem
  /// must have.
  std::string needs_in_words() const;

  bool operator==(const Capabilities&) const = default;
};

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

  /// It runs one of the others: patterns do not choose it, only its name does.
  bool chooses = false;

  /// Called in a process that is about to make others that run the solver, for what they can share;
  /// may be empty.
  std::function<void()> prepare = {};

  /// Hash of the files that a user's solver consists of, when it was loaded; empty: of the suite.
  std::string content = {};
  /// Returns the file of a user's solver that is another one now; "" if there is none.
  std::function<std::string()> changed_file = {};

  /// Returns true if the solver can run on the problem.
  bool accepts(const Problem& problem) const { return capabilities.accept(problem); }
};

/// Every solver of this build, with distinct names.
std::vector<Solver> all_solvers();

/// A solver that this build lacks, and the library that provides it.
struct MissingSolver {
  std::string solver;
  std::string library;
  Capabilities capabilities;
};

/// The solvers of libraries that were switched off or missing when ricochet was configured.
std::vector<MissingSolver> missing_solvers();

/// The solver with this name. Throws InputError, which begins with `asked_by`, e.g. "--solver", if
/// no solver has the name or this build lacks it.
Solver solver_named(const std::string& name, const std::string& asked_by = "solver");

}  // namespace ricochet
