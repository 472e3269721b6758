#pragma once

#include <string>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// How much more [m/s^2] than friction holds back the forces push a body that stays at `position`,
/// at most, in a direction that no wall blocks: it moves at some time if that is > 0. Forces that
/// do not repeat come as near to the sum of their amplitudes as one likes.
double release_margin(const Scene& scene, double position);

/// That margin with its exact derivatives with respect to the speed and to a constant (see
/// continuation_constants). A body on a wall stays on it.
struct ReleaseSlopes {
  double value;          ///< [m/s^2]
  double over_omega;     ///< per rad/s
  double over_constant;  ///< per unit of the constant
};
ReleaseSlopes release_slopes(const Scene& scene, double position, const std::string& constant);

}  // namespace ricochet::carrier_track::inline regimes
