#pragma once

#include <limits>
#include <string>

#include "ricochet/problem.h"

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

}  // namespace ricochet
