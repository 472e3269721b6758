#pragma once

#include <vector>

#include "problems/carrier_track/counting/threshold.h"

/// Where a staircase that rises and falls is quiet.
namespace ricochet::carrier_track::inline counting {

/// Neighbouring speeds of a scan that are all quiet [rad/s], the slowest and the fastest.
struct Pocket {
  double from, to;

  double width() const { return to - from; }
};

/// The pockets of counts up to `limit`, by rising speed.
std::vector<Pocket> quiet_pockets(const SpeedScan& scan, double limit);

}  // namespace ricochet::carrier_track::inline counting
