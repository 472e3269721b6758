#pragma once

#include <vector>

#include "ricochet/threshold.h"

/// The quiet ranges of speeds of a staircase that rises and falls.
namespace ricochet::carrier_track::inline counting {

/// The slowest and the fastest [rad/s] of neighbouring speeds of a scan that are all quiet.
struct QuietInterval {
  double from, to;

  double width() const { return to - from; }
};

/// The quiet intervals, in which all counts are <= `limit`, by increasing speed.
std::vector<QuietInterval> quiet_intervals(const SpeedScan& scan, double limit);

}  // namespace ricochet::carrier_track::inline counting
