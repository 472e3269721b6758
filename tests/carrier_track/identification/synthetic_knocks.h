#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/identification/knock_unknowns.h"
#include "ricochet/random.h"
#include "tests/support/scenes.h"

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

/// A carrier that is thrown from 2 rad/s on and rests on a wall each half turn.
inline Scene knocking_machine() {
  return with(Scene{}, set::mass(1.8), set::wall_upper(0.7e-3), set::restitution(0.5),
              set::friction(0.2), set::normal_force(11.8), set::contact_friction(true),
              set::pull(0.01), set::centrifugal_mass_radius(0.58), set::counting_limit(6e-3),
              set::start_position(0), set::phase(1));
}

/// Synthetic knocks of that machine, from 3 to 6 rad/s in 15 s.
inline KnockRecord example_record(const SensorModel& sensor = {}, std::uint64_t seed = 1) {
  Random random(seed);
  return synthetic_knocks(knocking_machine(), {{0, 3}, {15, 6}}, sensor, random);
}

/// A point near the truth of that record.
inline Vector example_point(const KnockRecord& record) {
  KnockUnknowns at = guess_of(knocking_machine());
  at.spurious_rate = 0.05 * static_cast<double>(record.knocks.size()) / record.duration();
  at.recorded_share = 0.95;
  return point_of(at);
}

/// A record as read_knock_record() has it, with marks if their angle has an error [rad].
inline KnockRecord measured_knocks(const Scene& truth, const std::vector<SpeedKnot<double>>& speed,
                                   const SensorModel& sensor, std::optional<double> mark_error,
                                   Random& random) {
  KnockRecord record = synthetic_knocks(truth, speed, sensor, random);
  record.lag_deviation = usual_lag_deviation;
  if (mark_error) {
    record.plate = plate_measurement(record, mark_times(truth, record, 1e-3, random), *mark_error,
                                     usual_mark_deviation);
  }
  take_out_sensor_faults(record);
  return record;
}

/// A minute of six speeds from 2 to 15 rad/s; the plate takes a second from one to the next.
inline std::vector<SpeedKnot<double>> six_speeds() {
  std::vector<SpeedKnot<double>> knots = {{0, 2}};
  for (int k = 0; k < 6; ++k) {
    const double speed = 2 + 13.0 * k / 5;
    if (k > 0) knots.push_back({10.0 * k + 1, speed});
    knots.push_back({10.0 * (k + 1), speed});
  }
  return knots;
}

/// A guess within 30 % of restitution and clearance, 20 % of friction.
inline Scene guess_near(Scene scene, Random& random) {
  const auto share = [&](double reach) { return 1 + reach * (2 * uniform(random) - 1); };
  scene.restitution_lower = scene.restitution_upper = scene.restitution_lower * share(0.3);
  scene.friction *= share(0.2);
  scene.wall_upper = scene.wall_lower + (scene.wall_upper - scene.wall_lower) * share(0.3);
  scene.start_position = scene.wall_lower;
  return scene;
}

}  // namespace ricochet::carrier_track::inline identification
