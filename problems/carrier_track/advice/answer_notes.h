#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::studies::advice {

/// How many of a window's collisions the start causes.
struct StartShare {
  double omega;  ///< [rad/s]
  double turns;  ///< of the window
  int count;     ///< collisions in the window
  int of_start;  ///< those beyond what the motion after the window has in as many turns, rounded

  /// Returns true if the count says more about the start than about the motion that follows.
  bool dominates() const { return of_start >= 2 && 10 * of_start > count; }
};

/// Counts in the window and in the ten turns after it.
StartShare start_share(const carrier_track::Scene& scene, double omega);

/// The share at the speed [rad/s], of some near the answer, at which the start causes most; nothing
/// without speeds.
std::optional<StartShare> largest_start_share(const carrier_track::Scene& scene,
                                              const std::vector<double>& speeds);

/// What an engineer should know beside the answer, one line each: the restitutions if the walls
/// differ, the speed up to which friction holds the carrier, by its hand formula, and whether the
/// window is too short, by the start's share in it.
std::string notes_on(const carrier_track::Scene& scene, const std::optional<StartShare>& share);

/// Revolutions per minute of 1 rad/s.
inline constexpr double rpm = 30 / std::numbers::pi;

/// "7.2 rad/s (68.8 rpm)"
std::string both_units(double omega);

}  // namespace ricochet::studies::advice
