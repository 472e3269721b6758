#pragma once

#include <vector>

#include "src/research/limits/goal_search.h"

/// An exhaustive scan of few parameters, with the others as in a fit.
namespace ricochet::studies::limits {

struct GridScan {
  Fit about;                                 ///< the fit that gives the other parameters
  std::vector<carrier_track::Unknown> axes;  ///< that are scanned
  int steps;                       ///< on each axis, at even shares of its bounds, ends included
  Fit lowest_error, lowest_worst;  ///< the best by each number, on the grid
  double threshold_error, worst_threshold;  ///< their values
  double own_error, own_worst;              ///< of the given fit
  /// The least error over all other axes at each point of the first two; a row for each place on
  /// the first.
  std::vector<std::vector<double>> map;
};

GridScan scanned_grid(const Fit& about, const std::vector<carrier_track::Unknown>& axes, int steps);

}  // namespace ricochet::studies::limits
