#pragma once

#include <string>
#include <vector>

#include "solvers/several_goals.h"
#include "src/research/calibration/appraisal.h"
#include "src/research/limits/goal_search.h"

/// Trade-offs between four goals, by the number of fitted parameters.
namespace ricochet::studies::limits {

/// The goals of a search: rms error of the thresholds, counts missed plus their distance, which is
/// below 1, 1 - worst purity, examples missed.
Vector goal_vector(const GoalValues& goals);

/// Reference point of hypervolumes: an error of 0.3, ten counts, no purity, ten examples.
Vector goal_reference();

/// Fronts of one interpretation with more and more free parameters, each started from the previous
/// one.
struct FrontChain {
  carrier_track::Interpretation interpretation;
  std::vector<std::vector<carrier_track::Unknown>> free;  ///< each includes the previous one
  int seed;
  int population, generations;  ///< of each
};

/// One front of a chain: fits and their goals.
struct ChainedFront {
  carrier_track::Parameterisation parameterisation;
  int seed;
  std::vector<Fit> fits;
  std::vector<GoalValues> goals;

  /// The share of the box from 0 to goal_reference() that it dominates.
  double dominated_share() const;
};

/// Searches all chains, in parallel; searches in the store are not repeated.
std::vector<ChainedFront> searched_fronts(const std::vector<FrontChain>& chains, FitStore& store);

}  // namespace ricochet::studies::limits
