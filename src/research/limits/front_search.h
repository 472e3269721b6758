#pragma once

#include <string>
#include <vector>

#include "solvers/several_goals.h"
#include "src/studies/calibration/appraisal.h"
#include "src/studies/limits/goal_search.h"

/// What can be had together of four goals, by the number of constants that are fitted.
namespace ricochet::studies::limits {

/// The goals as a search sees them: rms error of the thresholds, counts missed with their distance,
/// which is below 1, 1 - worst purity, examples missed.
Vector goal_vector(const GoalValues& goals);

/// Where hypervolumes end: an error of 0.3, ten counts, no purity, ten examples.
Vector goal_reference();

/// Fronts of one reading with more and more constants, each searched on from that before.
struct FrontChain {
  carrier_track::Reading reading;
  std::vector<std::vector<carrier_track::Open>> freed;  ///< each holds the one before
  int seed;
  int population, generations;  ///< of each
};

/// One front of a chain: fits, and what each reaches.
struct ChainedFront {
  carrier_track::Freedom freedom;
  int seed;
  std::vector<Fit> fits;
  std::vector<GoalValues> goals;

  /// The share of the box from 0 to goal_reference() that it dominates.
  double dominated_share() const;
};

/// All chains, in parallel; what the store holds is not searched again.
std::vector<ChainedFront> searched_fronts(const std::vector<FrontChain>& chains, FitStore& store);

}  // namespace ricochet::studies::limits
