#pragma once

#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"

namespace ricochet::carrier_track::inline regimes {

/// Turns of a settled motion that few phases have: with fewer or more collisions than any that the
/// motion knows, between phases whose turns differ much.
std::vector<DisturbedTurn> rare_turns(const DisturbedMotion& motion);

}  // namespace ricochet::carrier_track::inline regimes
