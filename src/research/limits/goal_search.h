#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/studies/calibration/fit_store.h"
#include "src/studies/limits/coarse_judgement.h"

/// Searches for the constants that are best by one number of a coarse judgement.
namespace ricochet::studies::limits {

using calibration::Fit;
using calibration::FitStore;

/// What is to be as low as can be.
struct Target {
  std::string name;
  bool of_thresholds;  ///< whether it does without C11, see judged_by_thresholds()
  std::function<double(const CoarseJudgement&)> value;
};

double value_of(const Target& target, const Fit& fit);

struct GoalSearch {
  carrier_track::Freedom freedom;  ///< where the search begins, if `from_held`
  Target target;
  Solver solver;
  int seed;
  std::int64_t evaluations;
  bool from_held = false;  ///< else from a uniform point
};

/// The best after a half of the evaluations and after all; Fit::misfit is the target's value.
struct GoalFound {
  Fit half, whole;
};

/// Makes those searches that the store does not hold, in parallel. The same searches find the same.
std::vector<GoalFound> searched(const std::vector<GoalSearch>& searches, const std::string& what,
                                FitStore& store);

/// The freedom of a reading with these constants at natural values; those that it has no use for
/// are left out.
carrier_track::Freedom freedom_of(const carrier_track::Reading& reading,
                                  const std::vector<carrier_track::Open>& freed);

/// A solver by its name. Throws InputError where this build does not have it.
Solver solver_named(const std::string& name);

}  // namespace ricochet::studies::limits
