#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/research/calibration/fit_store.h"

namespace ricochet::studies::calibration {

/// A search to be run, and the fits requested of it.
struct FitTask {
  std::vector<AskedFit> asked;               ///< at least one; the last is the final one
  std::function<std::vector<Fit>()> search;  ///< returns a fit for each
  double work;                               ///< in any unit, the same for all tasks
};

/// Returns a task that runs fit().
FitTask fit_task(const std::string& kind, const carrier_track::Parameterisation& parameterisation,
                 const Search& search, const std::string& left_out = "");

/// Loads or computes all requested fits, in parallel, the longest searches first.
std::vector<std::vector<Fit>> searched(const std::string& what, const std::vector<FitTask>& tasks,
                                       FitStore& store);

/// The same; returns the final fit of each search.
std::vector<Fit> fits_by(const std::string& what, const std::vector<FitTask>& tasks,
                         FitStore& store);

Search with_evaluations(Search search, std::int64_t evaluations);

}  // namespace ricochet::studies::calibration
