#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/complete_scan.h"
#include "problems/carrier_track/counting/limit.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"

/// How fast a machine of one's own may turn: the engineer's answer.
namespace ricochet::carrier_track::inline counting {

struct QuietSpeedOptions {
  std::optional<Limit> limit;  ///< without one the main step of the staircase tells
  double step = 1e-3;          ///< [rad/s]
  double fastest = 18;         ///< [rad/s]
};

/// The count at a speed, with whether it can be trusted.
struct CountThere {
  double omega;  ///< [rad/s]
  int count;
  double per_turn;
  bool certain;
  std::string doubt;  ///< empty if certain
};

struct QuietSpeed {
  QuietSpeedOptions options;
  LogarithmicScan scan;        ///< of counts, beyond the fastest speed
  SpeedScan fine;              ///< of counts, up to the fastest speed
  Staircase staircase;         ///< its steps located in the fine scan
  std::optional<Limit> limit;  ///< the one given, or that of the main step; nothing: no threshold
  Split split;                 ///< by that limit
  /// Speeds of a count above that limit, of collisions, which the fine scan steps over, if there
  /// are any below its first loud speed; split.first_loud is then their lowest.
  std::optional<CountPiece> stepped_over;
  std::optional<double> fastest_quiet;  ///< [rad/s], last scanned speed before the first loud one
  std::vector<CountThere> around;       ///< just below the answer, at it, and just above
};

/// Scans a valid scene, whose omega is not used. Takes some 20,000 simulations.
QuietSpeed quiet_speed(const Scene& scene, const QuietSpeedOptions& options);

}  // namespace ricochet::carrier_track::inline counting
