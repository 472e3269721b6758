#pragma once

#include <string>

#include "src/core/solver.h"

namespace ricochet {

/// What a solver takes, found out by asking it.
struct Acceptance {
  std::string variables;    ///< "any number", "1", "2 or more", "up to 8"
  std::string constraints;  ///< "none", "inequalities", "all", "needs inequalities"
  std::string needs;  ///< "nothing", "gradients", "Hessians", "residuals"; with "and a width" where
                      ///< the problem must have a smoothing width
};

/// Offers the solver problems of up to 64 variables. Throws std::logic_error for one that takes
/// none.
Acceptance acceptance_of(const Solver& solver);

}  // namespace ricochet
