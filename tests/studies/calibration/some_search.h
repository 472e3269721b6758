#pragma once

#include "problems/carrier_track/paper/fitted_reading.h"
#include "solvers/ceres_least_squares.h"
#include "solvers/solvers.h"
#include "src/studies/calibration/fit.h"

namespace ricochet::studies::calibration {

/// A search of so many evaluations by solvers that are cheap to start.
inline Search some_search(std::int64_t evaluations) {
  Search search;
  for (const Solver& solver : all_solvers()) {
    if (solver.name == "nlopt-crs2") search.global = solver;
    if (solver.name == "nlopt-sbplx") search.local = solver;
  }
  search.least_squares = ceres_least_squares();
  search.evaluations = evaluations;
  return search;
}

/// The default reading with its window and its slowest impact free.
inline carrier_track::Freedom some_freedom() {
  using namespace carrier_track;
  const FittedReading& fitted = default_reading();
  return {fitted.reading, {Open::start_velocity, Open::slowest}, fitted.constants};
}

}  // namespace ricochet::studies::calibration
