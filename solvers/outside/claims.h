#pragma once

#include <string>

#include "src/core/solver.h"

namespace ricochet::outside {

/// What a solver from outside says of itself.
struct Claims {
  std::string name, version;
  int takes_constraints = 0;  ///< 0: none; 1: inequalities; 2: equalities, too
  bool needs_derivatives = false;
  bool needs_residuals = false;
  bool stochastic = false;
};

/// A solver that is as it claims; what it does is left open. Throws InputError, naming `source`,
/// for a name that could not stand in a list of names, or a claim out of its range.
Solver solver_as_claimed(const Claims& claims, const std::string& source);

}  // namespace ricochet::outside
