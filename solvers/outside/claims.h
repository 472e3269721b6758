#pragma once

#include <string>

#include "ricochet/solver.h"

namespace ricochet::outside {

/// What an external solver declares about itself.
struct Claims {
  std::string name, version;
  int takes_constraints = 0;  ///< 0: none; 1: inequalities; 2: equalities, too
  bool needs_derivatives = false;
  bool needs_residuals = false;
  bool stochastic = false;
};

/// A solver with these claims; its `solve` is left empty. Throws InputError, naming `source`, for a
/// name that cannot stand in a list of names, or a claim out of range.
Solver solver_as_claimed(const Claims& claims, const std::string& source);

}  // namespace ricochet::outside
