#pragma once

#include <cstdint>
#include <string>

#include "problems/carrier_track/questions/calibration.h"
#include "src/core/solver.h"

namespace ricochet::studies::calibration {

/// Who searches, how long, and from which seed on.
struct Search {
  Solver global;
  Solver least_squares;      ///< polishes on the smooth misfit
  Solver local;              ///< polishes on the misfit
  std::int64_t evaluations;  ///< of the misfit, in all
  int seed = 1;
};

/// What a search found, and all that it was made from.
struct Fit {
  carrier_track::Reading reading;
  std::vector<carrier_track::Open> freed;
  carrier_track::Constants constants;  ///< fitted and held
  double misfit;
  std::string left_out;  ///< the case that it has not seen; empty: none
};

/// Fits the freed constants from the held ones on: the global solver has two thirds of the
/// evaluations, the least squares a sixth, the local solver a sixth; the best point of all counts.
/// The same search of the same freedom gives the same fit.
Fit fit(const carrier_track::Freedom& freedom, const Search& search,
        const std::string& left_out = "");

/// The two polishes alone, with all the evaluations.
Fit polish(const carrier_track::Freedom& freedom, const Search& search,
           const std::string& left_out = "");

}  // namespace ricochet::studies::calibration
