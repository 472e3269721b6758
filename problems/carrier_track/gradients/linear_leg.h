#pragma once

#include "problems/carrier_track/flight/plate_ramp.h"
#include "problems/carrier_track/flight/ramp_partials.h"

namespace ricochet::carrier_track::inline gradients {

/// The derivatives of the motion at the end of a flight of a given duration with respect to what
/// the forces depend on: the angle, the speed and the slope of the driver plate at its start, and,
/// for the disturbance, the time of the start. The forces do not depend on position or velocity, so
/// these add to what free motion makes of those.
template <class Scalar>
struct LegResponse {
  Motion<Scalar> by_angle, by_speed, by_slope, by_start;
};

/// The response of a flight of this duration [s] that starts at `start` [s].
template <class Scalar>
LegResponse<Scalar> response_of(const PlateForces<double>& plate,
                                const Harmonic<double>& disturbance, const Scalar& start,
                                const PlateRamp<Scalar>& ramp, double duration) {
  const RotationTaylor<Scalar> turning(ramp.angle, ramp.speed, ramp.slope);
  const RampPartials<Scalar> partials(plate, ramp.speed, ramp.slope, turning);
  const auto integrated = [duration](const Series<Scalar>& series) {
    const Motion<Scalar> by = integrals(series, duration);
    return Motion<Scalar>{by.position * (duration * duration), by.velocity * duration,
                          by.acceleration};
  };
  LegResponse<Scalar> response{integrated(partials.by_alpha),
                               integrated(partials.by_omega),
                               integrated(partials.by_slope),
                               {}};
  if (disturbance.cosine != 0 || disturbance.sine != 0) {
    const auto [cosine, sine, frequency] = after(disturbance, start);
    const Swung<Scalar> by =
        swung<Scalar>({-frequency * sine, frequency * cosine, frequency}, Scalar(duration));
    response.by_start = {by.position, by.velocity, by.cosine};
  }
  return response;
}

/// A flight linearised, with the event that ends it: all that a sweep needs. Scalar is double, or a
/// dual along directions of the knots' speeds.
template <class Scalar>
struct LinearLeg {
  Scalar start;               ///< [s]
  Scalar duration;            ///< [s]
  Scalar velocity;            ///< [m/s] at its end
  Scalar by_time;             ///< derivatives of the event's term, see EventTerm
  Scalar by_state;            ///< the same
  PlateRamp<double> release;  ///< of the start with respect to the ramp there, after a rest
  PlateRamp<Scalar> ramp{};   ///< at its start
  Scalar acceleration{};      ///< [m/s^2] at its end, if its start or its end may move
  LegResponse<Scalar> response{};
};

}  // namespace ricochet::carrier_track::inline gradients
