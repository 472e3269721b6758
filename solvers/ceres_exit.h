#pragma once

#include <ceres/types.h>

#include "src/core/solver.h"

/// For the adapters of Ceres alone.
namespace ricochet {

/// What Ceres says of its own end.
inline SolverExit in_words(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE:
      return "converged";
    case ceres::NO_CONVERGENCE:
      return "iterations spent";
    default:
      return "failure";
  }
}

}  // namespace ricochet
