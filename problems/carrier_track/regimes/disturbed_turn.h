#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline regimes {

/// What stands for the margin of an impact that is not there, or slower.
inline constexpr double lowest_margin = -6;

/// One turn of the driver plate under a disturbance.
struct DisturbedTurn {
  double phase;                 ///< [rad], of the disturbance at the start of the motion before
  std::vector<Impact> impacts;  ///< by time, those of margins above lowest_margin
  std::vector<double> speeds;   ///< [m/s], of these, the fastest first
  int collisions;
  double end_position = 0;            ///< [m]
  double end_velocity = 0;            ///< [m/s]
  bool returns = false;               ///< the carrier ends at rest where it started
  std::optional<Wall> rests_on = {};  ///< the wall on which it ends at rest
};

/// The turns that follow on `before` turns from the start of a valid scene of fidelity impact, for
/// these phases [rad] of its disturbance. Side by side, and without the last of a series of
/// rebounds: impacts are exact where the carrier rests before it moves again.
std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before);

/// The same of any such scenes that differ in their speed and in the phase of their disturbance.
std::vector<DisturbedTurn> turns_of(std::span<const Scene> scenes, int before);

/// ln(speed / counting limit) of the rank-th fastest impact of a turn, rank 1 the fastest. At least
/// lowest_margin.
double margin_of(const Scene& scene, const DisturbedTurn& turn, int rank);

}  // namespace ricochet::carrier_track::inline regimes
