#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/identification/knock_record.h"

namespace ricochet::carrier_track::inline identification {

inline constexpr double usual_mark_deviation = 0.05;  // [rad], 3 degrees
inline constexpr double usual_lag_deviation = 5e-3;   // [s]

/// Where a record comes from. Times are in seconds, of clocks that agree up to lag_deviation.
struct KnockFiles {
  std::string knocks;           ///< CSV: time [s], perhaps strength (> 0) and omega [rad/s]
  std::optional<double> omega;  ///< [rad/s], a constant speed of the driver plate
  std::string speed;            ///< CSV: time [s], omega [rad/s]; empty: none
  std::string marks;            ///< CSV: time [s] of marks on the plate; empty: none
  double mark_angle = 0;        ///< [rad], alpha at a mark
  /// Standard deviations of what is not known of the measurement; 0: it is exact.
  double mark_deviation = usual_mark_deviation;  ///< [rad], of mark_angle
  double lag_deviation = usual_lag_deviation;    ///< [s], of the lag between two files
};

/// Fewest knocks that a record may have.
inline constexpr std::size_t fewest_knocks = 20;

/// Reads a record. The sensor is taken to have listened from the first to the last time of all
/// files. Throws InputError, one line with file, line and column, for bad files, unless exactly one
/// source gives the speed, for fewer than fewest_knocks knocks or three marks, if the plate turns
/// less than two or more than 10,000 times, or if the files contradict each other: they do not
/// overlap, the knocks are fewer than one a turn, or from mark to mark the speeds give no turn.
KnockRecord read_knock_record(const KnockFiles& files);

/// Throws InputError, with `origin` and key, unless knocks can identify this machine: of fidelity
/// impact, with friction and one restitution of both walls, without a disturbance.
void check_identifiable(const Scene& scene, const std::string& origin);

}  // namespace ricochet::carrier_track::inline identification
