#pragma once

#include <span>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_turn.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// A turn with all that is told of it.
struct ObservedTurn {
  DisturbedTurn turn;
  double energy;         ///< [J], that the walls take
  double share_at_rest;  ///< of the time
};

/// The `turns` turns that follow on `before` turns from the start of a valid scene of fidelity
/// impact, for each of these phases [rad] of its disturbance; simulated to the last rebound.
std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns);

}  // namespace ricochet::carrier_track::inline regimes
