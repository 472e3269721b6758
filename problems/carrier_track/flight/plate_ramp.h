#pragma once

#include <cmath>

#include "problems/carrier_track/flight/harmonic.h"
#include "problems/carrier_track/flight/plate_forces.h"

namespace ricochet::carrier_track::inline flight {

/// The driver plate at one moment while its speed changes linearly. Scalar may also be a vector of
/// derivatives.
template <class Scalar>
struct PlateRamp {
  Scalar angle{};  ///< [rad]
  Scalar speed{};  ///< [rad/s]
  Scalar slope{};  ///< of the speed [rad/s^2]

  /// After a time [s].
  template <class Time>
  PlateRamp after(const Time& t) const {
    const Scalar gain = slope * t;
    return {angle + (speed + 0.5 * gain) * t, speed + gain, slope};
  }
};

/// The acceleration [m/s^2] by the plate.
template <class Scalar>
Scalar acceleration_of(const PlateForces<double>& plate, const PlateRamp<Scalar>& ramp) {
  using std::cos;
  using std::sin;
  const Scalar square = ramp.speed * ramp.speed;
  const Scalar cosine =
      plate.cosine + plate.square_cosine * square + plate.slope_cosine * ramp.slope;
  const Scalar sine = plate.sine + plate.square_sine * square + plate.slope_sine * ramp.slope;
  return plate.steady + plate.square * square + cosine * cos(ramp.angle) + sine * sin(ramp.angle);
}

/// A harmonic a time [s] later.
template <class Scalar>
Harmonic<Scalar> after(const Harmonic<double>& harmonic, const Scalar& time) {
  using std::cos;
  using std::sin;
  const Scalar c = cos(harmonic.frequency * time);
  const Scalar s = sin(harmonic.frequency * time);
  return {harmonic.cosine * c - harmonic.sine * s, harmonic.sine * c + harmonic.cosine * s,
          Scalar(harmonic.frequency)};
}

}  // namespace ricochet::carrier_track::inline flight
