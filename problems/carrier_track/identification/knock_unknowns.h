#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/machine.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline identification {

/// What recorded knocks are explained by: constants of the machine, then what is unknown of the
/// plate, then what is unknown of the sensor.
struct KnockUnknowns {
  double restitution;        ///< in (0, 1), of both walls
  double friction;           ///< > 0
  double clearance;          ///< [m], > 0
  double phase;              ///< [rad], alpha at the record's start
  double speed_factor;       ///< > 0, true over recorded speed of the driver plate
  double jitter;             ///< [s], > 0, standard deviation of a recorded time
  double recorded_share;     ///< in (0, 1), of the impacts on the lower wall that are strong enough
  double spurious_rate;      ///< [1/s], > 0
  double detection_limit;    ///< > 0, impacts that are weaker are missed; in units of strength
  double gain;               ///< > 0, strength over impact speed [1/(m/s)]
  double scatter;            ///< > 0, standard deviation of the logarithm of a strength
  double upper_share = 0.9;  ///< in (0, 1), as recorded_share, of the impacts on the upper wall
  double lag = 0;            ///< [s], how late the knocks' clock is at the record's start
  double drift = 0;  ///< > -1, how much faster the knocks' clock runs than that of the speed
};

/// A point of the fit: the unknowns in this order on scales without bounds: logarithms, logits of
/// restitution and the shares; phase, lag and drift themselves.
inline constexpr Eigen::Index knock_unknowns = 14;

/// The index of each unknown's coordinate.
namespace coordinate {
enum : Eigen::Index {
  restitution,
  friction,
  clearance,
  phase,
  speed_factor,
  jitter,
  recorded_share,
  spurious_rate,
  detection_limit,
  gain,
  scatter,
  upper_share,
  lag,
  drift
};
}

/// The unknowns that motion depends on are the first ones.
inline constexpr Eigen::Index motion_unknowns = 5;

/// The constants of the machine are the first ones of these.
inline constexpr Eigen::Index machine_constants = 3;

inline constexpr std::array<std::string_view, machine_constants> constant_names = {
    "restitution", "friction", "clearance"};

Vector point_of(const KnockUnknowns& unknowns);
KnockUnknowns unknowns_at(const Vector& x);

/// d unknown / d coordinate at a point, for each of the machine's constants: length
/// machine_constants.
Vector slopes_at(const Vector& x);

/// A guess before any knock is known: the scene's constants; 1 ms of jitter.
KnockUnknowns guess_of(const Scene& scene);

/// The scene with these constants of the machine. The upper wall moves.
Scene with_constants(Scene scene, const KnockUnknowns& unknowns);

/// An impact that a simulation predicts, with derivatives by the motion's unknowns, i.e. by the
/// first coordinates of a point, see KnockUnknowns. By the lag the time has the slope 1, by the
/// drift the time since the record's start on the clock of the speeds.
struct PredictedImpact {
  double time;       ///< [s], of the record's clock
  double log_speed;  ///< ln of the approach speed [m/s]
  Wall wall = Wall::lower;
  std::array<double, motion_unknowns> time_slopes = {};
  std::array<double, motion_unknowns> log_speed_slopes = {};
};

/// The impacts faster than `slowest` [m/s] of a scene at the unknowns x while a record was made, in
/// order of time. The carrier is let settle for two turns before, at the record's first speed. What
/// the unknowns do not name is the scene's. The scene must be of fidelity impact.
std::vector<PredictedImpact> predicted_impacts(const Scene& scene, const KnockRecord& record,
                                               const Vector& x, double slowest);

/// The same without derivatives, which takes half the time.
std::vector<PredictedImpact> plain_impacts(const Scene& scene, const KnockRecord& record,
                                           const Vector& x, double slowest);

}  // namespace ricochet::carrier_track::inline identification
