#pragma once

#include <optional>

#include "problems/carrier_track/counting/quiet_speed.h"

namespace ricochet::cli {

/// What a user asks of a machine's quiet speed.
struct QuietSpeedRequest {
  double fastest = 18.0;                 ///< [rad/s], end of the range searched
  std::optional<double> allow;           ///< collisions in the window
  std::optional<double> allow_per_turn;  ///< collisions
  std::optional<double> allow_energy;    ///< [J], in the window
  std::optional<double> allow_speed;     ///< [m/s], of the fastest impact
  double tolerance = 0;                  ///< [%], of every constant
};

/// Throws InputError for what is out of range, and for more than one limit.
carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request);

/// Throws InputError for a scene with a speed profile: a threshold is of constant speeds.
void refuse_profile(const carrier_track::Scene& scene, const std::string& name);

}  // namespace ricochet::cli
