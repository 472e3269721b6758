#pragma once

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// How much more [m/s^2] than friction holds back the forces push a body that stays at `position`,
/// at most, in a direction that no wall blocks: it moves at some time if that is > 0. Forces that
/// do not repeat come as near to the sum of their amplitudes as one likes.
double release_margin(const Scene& scene, double position);

}  // namespace ricochet::carrier_track::inline regimes
