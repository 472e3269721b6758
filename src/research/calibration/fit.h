#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/research/paper/calibration_problem.h"

namespace ricochet::studies::calibration {

/// Solvers, evaluations and first seed of a search.
struct Search {
  Solver global;
  Solver least_squares;      ///< polishes on the smooth loss
  Solver local;              ///< polishes on the loss
  std::int64_t evaluations;  ///< of the loss, in all
  int seed = 1;
};

/// The result of a search, and everything that determined it.
struct Fit {
  carrier_track::Interpretation interpretation;
  std::vector<carrier_track::Unknown> free;
  carrier_track::Constants constants;  ///< fitted and fixed
  double loss;
  std::string left_out;  ///< the case left out of the fit; empty: none
};

/// Name of an unknown parameter in words: "centrifugal mass radius".
std::string words_of(carrier_track::Unknown constant);

/// Fits the free parameters, starting at the values in `held`: the global solver has two thirds of
/// the evaluations, the least squares a sixth, the local solver a sixth; returns the best point of
/// all. The result depends only on search and parameterisation.
Fit fit(const carrier_track::Parameterisation& parameterisation, const Search& search,
        const std::string& left_out = "");

/// Only the two local searches, with all the evaluations.
Fit polish(const carrier_track::Parameterisation& parameterisation, const Search& search,
           const std::string& left_out = "");

/// Returns the best point of a run within this number of evaluations as a fit; the values in
/// `held`, with the given loss, if nothing is better.
Fit best_within(std::int64_t evaluations, const RunRecord& record,
                const carrier_track::Parameterisation& parameterisation, double loss_of_held);

}  // namespace ricochet::studies::calibration
