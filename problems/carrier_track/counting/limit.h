#pragma once

#include <span>
#include <vector>

#include "ricochet/threshold.h"

/// A limit that a user sets on the collisions, the energy or the impact speed of a machine.
namespace ricochet::carrier_track::inline counting {

/// The measure of a valid scene at the speed of the scene.
double measured(const Scene& scene, Measure measure);

/// The same at several speeds [rad/s]; neighbours should be similar.
std::vector<double> measured_at(const Scene& scene, Measure measure,
                                std::span<const double> speeds);

/// At the speeds step, 2 step, ..., highest [rad/s], or as many of the slowest as the TimeLimit
/// allows: 1 where the limit is exceeded, 0 where it is kept.
SpeedScan scan_by(const Scene& scene, const Limit& limit, double step, double highest);

/// The split of the speeds step, 2 step, ..., highest [rad/s] into those that keep the limit and
/// those that exceed it, with the fewest misclassified. first_loud is the lowest speed that exceeds
/// it; it does not depend on the end of the range.
Split split_by(const Scene& scene, const Limit& limit, double step, double highest);

}  // namespace ricochet::carrier_track::inline counting
