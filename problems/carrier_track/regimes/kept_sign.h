#pragma once

#include "problems/carrier_track/regimes/followed_motion.h"

namespace ricochet::carrier_track::inline regimes {

/// Whether a margin keeps its sign over a step, by the cubic through the values and slopes at both
/// ends. The cubic's error is of the size of `surprise`, the difference between the rise and what
/// the slopes say, and of a share of how far its extremum is from the nearer end.
bool keeps_sign(const Margin& a, const Margin& b, double step);

}  // namespace ricochet::carrier_track::inline regimes
