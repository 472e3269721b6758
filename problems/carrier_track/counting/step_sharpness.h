#pragma once

#include <optional>

#include "ricochet/threshold.h"

/// Tests whether the count makes a step at a threshold, as the paper says: "the number of
/// collisions is 5" below, above it "increases significantly".
namespace ricochet::carrier_track::inline counting {

/// The way in which a count becomes loud.
enum class Rise {
  step,   ///< it stays loud, and most of the rise is at one speed
  climb,  ///< it stays loud, but rises gradually: the threshold is a convention
  none    ///< it does not stay loud: no significant increase
};

/// The sharpness of a count on the two ranges next to a threshold: down to the threshold / `reach`,
/// and up to `reach` times the threshold or the end of the scan.
struct StepSharpness {
  double threshold;    ///< [rad/s]
  int before, after;   ///< the median counts of the two ranges
  double width;        ///< [rad/s], from the end of `before` to the start of `after`
  double persistence;  ///< share of loud speeds in the range above, in [0, 1]
  Rise rise;
};

/// Least share of loud speeds in the range above for a rise.
inline constexpr double least_persistence = 0.9;

/// Largest width of a step, as a share of its speed.
inline constexpr double widest_step = 0.1;

/// The sharpness at a threshold [rad/s] between two scanned speeds. A speed is loud if it has more
/// than `limit` collisions, see quiet_limit. The ends of the rise are the splits that put the
/// fewest speeds of both ranges on the wrong side, so that a single speed does not widen it. A step
/// has `after` at least 50 % above `before`, and at most the width widest_step. Nothing if one of
/// the ranges has no scanned speed.
std::optional<StepSharpness> step_sharpness(const SpeedScan& scan, double threshold, double limit,
                                            double reach = 1.5);

}  // namespace ricochet::carrier_track::inline counting
