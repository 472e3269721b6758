#pragma once

#include <optional>

#include "ricochet/machine.h"
#include "src/app/command_line.h"

namespace ricochet::cli {

/// The user's options for a machine's quiet speed.
struct QuietSpeedRequest {
  double fastest = 18.0;                 ///< [rad/s], end of the range searched
  std::optional<double> allow;           ///< collisions in the window
  std::optional<double> allow_per_turn;  ///< collisions
  std::optional<double> allow_energy;    ///< [J], in the window
  std::optional<double> allow_speed;     ///< [m/s], of the fastest impact
  double tolerance = 0;                  ///< [%], of every model parameter
  double seconds = 60;                   ///< time limit
};

/// Adds the options of a request.
void add_request(CLI::App* command, QuietSpeedRequest& asked);

/// Throws InputError if a value is out of range, or if more than one limit is given.
carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request);

}  // namespace ricochet::cli
