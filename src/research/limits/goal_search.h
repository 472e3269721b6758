#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/research/calibration/fit_store.h"
#include "src/research/limits/coarse_judgement.h"

/// Searches for the parameters that minimise one number of a coarse evaluation.
namespace ricochet::studies::limits {

using calibration::Fit;
using calibration::FitStore;

/// The number to minimise.
struct Target {
  std::string name;
  bool of_thresholds;  ///< true if it does not need C11, see judged_by_thresholds()
  std::function<double(const CoarseJudgement&)> value;
};

double value_of(const Target& target, const Fit& fit);

struct GoalSearch {
  carrier_track::Parameterisation parameterisation;  ///< gives the start, if `from_held`
  Target target;
  Solver solver;
  int seed;
  std::int64_t evaluations;
  bool from_held = false;  ///< otherwise it starts from a uniform random point
};

/// The best after half of the evaluations and after all of them; Fit::loss is the target's value.
struct GoalFound {
  Fit half, whole;
};

/// Runs the searches that are not in the store, in parallel. Results are reproducible.
std::vector<GoalFound> searched(const std::vector<GoalSearch>& searches, const std::string& what,
                                FitStore& store);

/// The parameterisation of an interpretation with these free parameters at natural values; those
/// that it does not use are left out.
carrier_track::Parameterisation parameterisation_of(
    const carrier_track::Interpretation& interpretation,
    const std::vector<carrier_track::Unknown>& free);

}  // namespace ricochet::studies::limits
