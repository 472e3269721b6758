#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/threshold.h"

/// The levels and the steps of a collision count that depends on the speed, without a given limit.
namespace ricochet::carrier_track::inline counting {

/// Counts at the speeds from `lowest` to `highest` [rad/s], both > 0, in parallel.
LogarithmicScan scan_logarithmically(const CountAt& count, double lowest, double highest);

/// The same for a valid scene, whose omega is not used.
LogarithmicScan scan_logarithmically(const Scene& scene, double lowest, double highest);

/// The slowest speed [rad/s] at which steps are searched: 0.1 revolutions per minute.
inline constexpr double slowest_scanned = 0.01;

/// The ratio of the end of a scan to the fastest speed of the staircase. It makes the scan contain
/// all speeds that affect the significance of any step.
inline constexpr double judged_share = 2.25;

/// The staircase of the speeds up to `fastest` [rad/s]. The scan should extend to judged_share
/// times that speed.
Staircase staircase_of(const LogarithmicScan& scan, double fastest);

}  // namespace ricochet::carrier_track::inline counting
