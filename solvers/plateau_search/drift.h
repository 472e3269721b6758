#pragma once

#include <cstdint>

#include "solvers/plateau_search/sight.h"

namespace ricochet::drifting {

/// How a drift begins and when it has come to nothing.
struct DriftLimits {
  double step;            ///< the first one's deviation in every coordinate, of the box
  std::int64_t patience;  ///< steps without a strictly better point
};

/// A (1+1) evolution strategy with covariance adaptation (Igel, Suttorp and Hansen 2006, doi
/// 10.1145/1143997.1144082; failures shrink the covariance as in Arnold and Hansen 2010, doi
/// 10.1145/1830483.1830556; broken constraints as in Arnold and Hansen 2012, doi
/// 10.1145/2330163.2330207) that moves to every point that is not worse, and counts that as a
/// success for the step's size and shape. What is added:
/// - Every other step, at random, moves only some coordinates, from one to all, by as much in all.
/// - A step out of the box ends on its boundary; a point that was asked for is not asked for again.
/// - Where there are constraints, ten steps are drawn, and the one taken whose nearest neighbour
///   among the last 300 points of this drift is best.
/// Leaves the last point, the best of all, in `at`. False once the run is over.
bool drift(Sight& sight, Seen& at, const DriftLimits& limits, Random& random);

}  // namespace ricochet::drifting
