#pragma once

#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// The collisions in a turn at one speed, as simulated from some phases of the disturbance: turns
/// that fewer phases have are missed.
struct SampledTurns {
  double omega;  ///< [rad/s]
  double mean_per_turn;
  int most_per_turn;
};

inline constexpr int sampled_phases = 24;
inline constexpr int sampled_turns_each = 20;  ///< after as many to settle

/// Simulates turns of a valid scene with regimes (has_regimes) at speeds [rad/s] with equal ratios,
/// from `from` to `to`, both included. If a TimeLimit is reached, the slower speeds are missing.
std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to);

}  // namespace ricochet::carrier_track::inline regimes
