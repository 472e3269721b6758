#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/scene.h"

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

/// The fastest speed [rad/s] up to which a machine has at most quiet_per_turn collisions a turn in
/// the long run, from rest on the lower wall; nothing if every speed up to `fastest` [rad/s] has,
/// or not even its 200th. The scene's start and speed are not used.
std::optional<double> safe_speed(const Scene& scene, double fastest = 18);

/// Finds what a sensor does beside recording each impact once, and says so in the record's notes.
/// Knocks at one time become one, the strongest. Echoes, i.e. knocks that follow others at a fixed
/// delay, with strengths also at a fixed ratio, are removed. Of the record's fields, dead_time is
/// set to the shortest interval that is left, at most 50 ms, and saturation to the largest strength
/// if several knocks have it.
///
/// Rebounds are no echoes: fewer knocks have one of the same delay, and the delay changes with the
/// speed of the plate. Where that does not tell them apart, they stay, and a note says so.
void take_out_sensor_faults(KnockRecord& record);

}  // namespace ricochet::carrier_track::inline identification
