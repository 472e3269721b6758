#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// What a sensor does to the impacts of a machine.
struct SensorModel {
  double jitter = 1e-3;           ///< [s], standard deviation of a recorded time
  double missed_share = 0.05;     ///< of the impacts above the detection limit
  double spurious_share = 0.05;   ///< spurious knocks over detected ones
  double detection_limit = 6e-3;  ///< [m/s]
  double scatter = 0.05;          ///< standard deviation of the logarithm of a strength
  bool strengths = false;         ///< whether it records strengths, in m/s
  /// [s], standard deviation of the time of a mark at alpha = 0; nothing: there are no marks.
  std::optional<double> mark_jitter = {};
  double lag = 0;         ///< [s], how late the clock of the knocks is
  double drift = 0;       ///< how much faster that clock runs
  double echo_delay = 0;  ///< [s], after which a knock rings again, and again; 0: never
  double echo_ratio = 0.6;
  double dead_time = 0;   ///< [s], without any knock after a recorded one
  double upper_gain = 1;  ///< strength on the upper wall over that on the lower one
  double saturation = std::numeric_limits<double>::infinity();  ///< largest strength [m/s]
};

/// Knocks as a sensor would record them from 0 s until the last knot of a speed profile. The
/// scene's phase is the plate's angle at 0 s.
KnockRecord synthetic_knocks(const Scene& scene, const std::vector<SpeedKnot<double>>& speed,
                             const SensorModel& sensor, Random& random);

/// When [s] a mark at alpha = 0 passes while a record is made, each with a Gaussian error of this
/// deviation [s]. The scene's phase is that at the record's start.
std::vector<double> mark_times(const Scene& scene, const KnockRecord& record, double jitter,
                               Random& random);

}  // namespace ricochet::carrier_track::inline identification
