#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/complete_scan.h"
#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"

/// The fastest quiet speed of a user's machine.
namespace ricochet::carrier_track::inline counting {

struct QuietSpeedOptions {
  std::optional<Limit> limit;  ///< default: the limit of the staircase's main step
  double step = 1e-3;          ///< [rad/s]
  double fastest = 18;         ///< [rad/s]
};

/// The count at a speed, and its certainty.
struct CountThere {
  double omega;  ///< [rad/s]
  int count;
  double per_turn;
  bool certain;
  std::string doubt;  ///< empty if certain
};

struct QuietSpeed {
  QuietSpeedOptions options;
  LogarithmicScan scan;        ///< counts, beyond the fastest speed
  SpeedScan fine;              ///< counts, up to the fastest speed
  Staircase staircase;         ///< with its steps located in the fine scan
  std::optional<Limit> limit;  ///< given, or of the main step; nothing if there is no threshold
  Split split;                 ///< by that limit
  /// Speeds below the first loud speed of the fine scan that it steps over and whose collision
  /// count is above the limit, if any; split.first_loud is then the lowest of them.
  std::optional<CountPiece> stepped_over;
  std::optional<double> fastest_quiet;  ///< [rad/s], last scanned speed before the first loud one
  std::vector<CountThere> around;       ///< just below the answer, at it, and just above
};

/// Scans a valid scene, whose omega is not used. Takes about 20,000 simulations.
QuietSpeed quiet_speed(const Scene& scene, const QuietSpeedOptions& options);

}  // namespace ricochet::carrier_track::inline counting
