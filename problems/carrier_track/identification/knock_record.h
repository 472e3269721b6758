#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"
#include "ricochet/vector.h"

namespace ricochet::carrier_track::inline identification {

/// A knock that a sensor has recorded.
struct Knock {
  double time;                          ///< [s]
  std::optional<double> strength = {};  ///< > 0, in any unit; of all knocks, or of none
};

/// A measurement of the plate's angle and speed, with the information (inverse covariance) on both.
struct PlateMeasurement {
  double phase;        ///< [rad], alpha at the record's start
  double log_speed;    ///< ln of true over recorded speed
  Matrix information;  ///< 2 x 2, in this order
  double deviation;    ///< [rad], of a single mark
};

/// Recorded knocks, and the speed of the driver plate meanwhile.
struct KnockRecord {
  std::vector<Knock> knocks;             ///< by rising time, within from..to
  std::vector<SpeedKnot<double>> speed;  ///< at least one; linear between knots, constant outside
  double from = 0, to = 0;               ///< [s], when the sensor listened
  /// What marks on the plate say; without it the angle is unknown.
  std::optional<PlateMeasurement> plate = {};
  /// [s], standard deviation of the lag of the knocks behind the speeds; 0: both have one clock.
  double lag_deviation = 0;
  /// [s], for which the sensor is deaf after each knock.
  double dead_time = 0;
  /// Stronger knocks are recorded with this strength.
  double saturation = std::numeric_limits<double>::infinity();
  std::vector<std::string> notes = {};  ///< what was taken out of it, one sentence each

  double duration() const { return to - from; }  ///< [s]
  bool has_strengths() const { return !knocks.empty() && knocks.front().strength.has_value(); }
};

/// The speed of the driver plate [rad/s] at a time [s].
double speed_at(const std::vector<SpeedKnot<double>>& speed, double time);

/// The angle [rad] that the driver plate turns from `from` to `to` [s], from <= to.
double angle_between(const std::vector<SpeedKnot<double>>& speed, double from, double to);

/// What marks say of the plate: at each of these times [s], at least three and rising, alpha is
/// `mark_angle` [rad], turns apart. Marks may be missed. The record's speeds may be wrong by a
/// common factor of up to 10 %. `mark_angle` is known to `angle_deviation` [rad], and the marks lag
/// the speeds by 0 +- `record.lag_deviation`.
PlateMeasurement plate_measurement(const KnockRecord& record, const std::vector<double>& marks,
                                   double mark_angle, double angle_deviation = 0);

}  // namespace ricochet::carrier_track::inline identification
