#pragma once

#include "ricochet/solver.h"
#include "solvers/library_solvers.h"
#include "src/studies/calibration/fit.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::calibration {

/// A search of so many evaluations by solvers that are cheap to start.
inline Search some_search(std::int64_t evaluations) {
  return {solver_named("nlopt-crs2"), ceres_least_squares(), solver_named("nlopt-sbplx"),
          evaluations};
}

/// The default interpretation with its window and its slowest impact free.
inline carrier_track::Parameterisation some_parameterisation() {
  using namespace carrier_track;
  const FittedInterpretation& fitted = default_interpretation();
  return {
      fitted.interpretation, {Unknown::start_velocity, Unknown::counting_limit}, fitted.constants};
}

}  // namespace ricochet::studies::calibration
