#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/studies/calibration/fit_store.h"

namespace ricochet::studies::calibration {

/// A fit to be made, and how.
struct FitTask {
  std::string kind;  ///< of search, for the store
  std::function<Fit(const carrier_track::Freedom&, const Search&, const std::string&)> make;
  carrier_track::Freedom freedom;
  Search search;
  std::string left_out = {};
};

/// Fetches or makes all fits, in parallel.
std::vector<Fit> done(const std::string& what, const std::vector<FitTask>& tasks, FitStore& store);

Search with_evaluations(Search search, std::int64_t evaluations);

}  // namespace ricochet::studies::calibration
