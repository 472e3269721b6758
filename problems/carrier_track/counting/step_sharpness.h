#pragma once

#include <optional>

#include "problems/carrier_track/counting/threshold.h"

/// Whether the count makes a step at a threshold, as the paper has it: "the number of collisions is
/// 5" below, above it "increases significantly".
namespace ricochet::carrier_track::inline counting {

/// How a count becomes loud.
enum class Rise {
  step,   ///< it stays loud, and most of the way is made at once
  climb,  ///< it stays loud, but goes there by and by: where the threshold lies is a convention
  none    ///< it does not stay loud: there is no significant increase
};

/// Of the count on the two stretches next to a threshold: down to a `reach`-th of its speed, and up
/// to `reach` times that, or where the scan ends.
struct StepSharpness {
  double threshold;    ///< [rad/s]
  int before, after;   ///< the median counts of the stretches
  double width;        ///< [rad/s], from where the count leaves `before` to where it has `after`
  double persistence;  ///< share of the speeds of the stretch above that are loud, in [0, 1]
  Rise rise;
};

/// A rise needs this share of the stretch above to be loud.
inline constexpr double least_persistence = 0.9;

/// A step is no wider than this share of its speed.
inline constexpr double widest_step = 0.1;

/// The sharpness at a threshold [rad/s] between two scanned speeds. Loud is what has more than
/// `limit` collisions, see quiet_limit. The count leaves a level, and has one, where the split lies
/// that puts the fewest speeds of both stretches on the wrong side, so that a lone speed widens
/// nothing. A step has `after` at least half as high again as `before`, within widest_step.
/// Nothing where one of the stretches has no scanned speed.
std::optional<StepSharpness> step_sharpness(const SpeedScan& scan, double threshold, double limit,
                                            double reach = 1.5);

}  // namespace ricochet::carrier_track::inline counting
