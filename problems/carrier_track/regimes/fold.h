#pragma once

#include <optional>

#include "problems/carrier_track/regimes/steady_motion.h"

namespace ricochet::carrier_track::inline regimes {

/// The speed [rad/s] of the fold at which an orbit that never rests vanishes: the zero of what the
/// orbit misses its start by, and of its fold margin, by Newton's method from an orbit nearby.
/// Nothing if that does not converge within 1 % of the speed.
std::optional<double> fold_near(const SteadyMotion& orbit);

}  // namespace ricochet::carrier_track::inline regimes
