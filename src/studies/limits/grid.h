#pragma once

#include <vector>

#include "src/studies/limits/goal_search.h"

/// An exhaustive scan of few constants, with the others where a fit has them.
namespace ricochet::studies::limits {

struct GridScan {
  Fit about;                              ///< the fit whose other constants are held
  std::vector<carrier_track::Open> axes;  ///< that are scanned
  int steps;                       ///< on each, evenly over its bounds' shares, ends included
  Fit lowest_error, lowest_worst;  ///< the best by each, on the grid
  double threshold_error, worst_threshold;  ///< theirs
  double own_error, own_worst;              ///< of the fit itself
  /// The least error over all other axes at each place of the first two, the first in rows.
  std::vector<std::vector<double>> map;
};

GridScan scanned_grid(const Fit& about, const std::vector<carrier_track::Open>& axes, int steps);

}  // namespace ricochet::studies::limits
